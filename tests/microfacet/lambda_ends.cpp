// Lambda and densities where parameters are near the ends of their domains, or at values that are special to a formula,
// against 20-digit values. They were computed with mpmath at 40 digits or more: sheen from 2F1, velvet and GTR from
// their definitions, Phong from the incomplete beta function at 120 digits, GTR, Phong's a Lambda and shapes from
// 2 int p(a^2 + t^2) t^2 (1 - atan(t / a) a / t) dt, cut where the densities have their peaks.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace test;

namespace {

/// a Lambda(a) of the profile or shape of a distribution.
template <class D>
double a_lambda(const TermDescription& description, double a) {
  const Material material = build(description);
  const D& d = std::get<D>(material.surface().distribution);
  if constexpr (requires { d.profile; })
    return d.profile.a_lambda(a);
  else
    return d.shape.a_lambda(a);
}

} // namespace

TEST_CASE("sheen: Lambda where half of the power is a whole number, and the series has a term that is 0") {
  struct Row {
    double alpha, theta, lambda;
  };
  for (const Row& row : {Row{0.5, 0.001, 5.0000014583339724306e-7},      Row{0.5, 0.05, 0.0012509124576043543631},
                         Row{0.5, 0.15, 0.011324562521237495648},        Row{0.5, 0.349, 0.063185416989464841571},
                         Row{0.5, 0.6, 0.20238733215681793721},          Row{0.5, 1.2, 1.4791882623801362015},
                         Row{0.25, 0.001, 7.5000012500009586459e-7},     Row{0.25, 0.05, 0.0018757827485553490404},
                         Row{0.25, 0.15, 0.016939380528031667343},       Row{0.25, 0.349, 0.093385254659071014743},
                         Row{0.25, 0.6, 0.29126311504485584061},         Row{0.25, 1.2, 1.9483642988345051227},
                         Row{1.0 / 6, 0.001, 1.0000000416668361944e-6},  Row{1.0 / 6, 0.05, 0.002500263064755027081},
                         Row{1.0 / 6, 0.15, 0.022523027341161070241},    Row{1.0 / 6, 0.349, 0.12272882097356407664},
                         Row{1.0 / 6, 0.6, 0.37366855150217241941},      Row{1.0 / 6, 1.2, 2.3439148862438456052},
                         Row{0.125, 0.001, 1.2499998958336493575e-6},    Row{0.125, 0.05, 0.0031243538931134686362},
                         Row{0.125, 0.15, 0.028075850031810078724},      Row{0.125, 0.349, 0.15126540294439684022},
                         Row{0.125, 0.6, 0.45058618207935473124},        Row{0.125, 1.2, 2.6916801532028781333},
                         Row{1.0 / 12, 0.001, 1.7499994166676196e-6},    Row{1.0 / 12, 0.05, 0.0043713690301481910443},
                         Row{1.0 / 12, 0.15, 0.039090387226092034515},   Row{1.0 / 12, 0.349, 0.20609721189084353869},
                         Row{1.0 / 12, 0.6, 0.59098001886747304514},     Row{1.0 / 12, 1.2, 3.2935712003655431094},
                         Row{1.0 / 24, 0.001, 3.2499964791745301497e-6}, Row{1.0 / 24, 0.05, 0.00810311713671210009},
                         Row{1.0 / 24, 0.15, 0.071428850131051846014},   Row{1.0 / 24, 0.349, 0.35536670865792526988},
                         Row{1.0 / 24, 0.6, 0.93896072145157333572},     Row{1.0 / 24, 1.2, 4.6979426902348595784}}) {
    INFO("r = " << row.alpha << ", theta = " << row.theta);
    CHECK(relative(lambda(material("sheen", row.alpha), from_angles(row.theta, 0.4)), row.lambda) < 1e-12);
  }
  // Half the power is 2: (1 + s^2 - s^4 / 8) / c.
  const Direction o = from_angles(20 * degree, 0);
  const double s2 = o.x * o.x;
  CHECK(relative(lambda(material("sheen", 0.25), o), 0.5 * ((1 + s2 - s2 * s2 / 8) / o.z - 1)) < 1e-13);
}

TEST_CASE("sheen: Lambda by its table is that by its integral, for every roughness and angle") {
  double worst = 0;
  for (double alpha = 1e-6; alpha <= 1e6; alpha *= inputs(4.7, 1e4)) {
    const Material m = material("sheen", alpha);
    const SheenProfile& profile = std::get<Sheen>(m.surface().distribution).profile;
    REQUIRE(profile.table);
    CHECK(profile.a_lambda(infinity) == 0);
    for (double a = 0; a < 1e80; a = a < 1e-9 ? a + 1e-10 : a < 30 ? 1.17 * a : 3 * a * a)
      worst = std::fmax(worst, relative(profile.a_lambda(a), profile.exact_a_lambda(a)));
  }
  MESSAGE("largest relative difference: " << worst);
  CHECK(worst < 5e-13);
}

TEST_CASE("velvet: P22 where the base has all the weight but 1e-14, or next to none") {
  struct Row {
    double alpha, amplitude, slope, p22;
  };
  for (const Row& row : {Row{1e-06, 0.001, 0.3, 0.2679150628598521649},
                         Row{1e-06, 0.001, 1000000.0, 3.1842698584620237165e-25},
                         Row{1e-06, 0.001, 3000000.0, 3.9332681775902170427e-27},
                         Row{1e-06, 4.0, 0.3, 0.26791506285878077256},
                         Row{1e-06, 4.0, 1000000.0, 7.8670853837456046074e-25},
                         Row{1e-06, 4.0, 3000000.0, 1.799573692012026526e-26},
                         Row{1e-06, 1000000.0, 0.3, 0.26791479494505748776},
                         Row{1e-06, 1000000.0, 1000000.0, 1.1709986425866023528e-19},
                         Row{1e-06, 1000000.0, 3000000.0, 3.5164967229828970902e-21},
                         Row{1.6e-06, 0.001, 0.3, 0.26791506285985174695},
                         Row{1.6e-06, 0.001, 625000.0, 2.0868430944351600513e-24},
                         Row{1.6e-06, 0.001, 3000000.0, 3.9335145192833250578e-27},
                         Row{1.6e-06, 4.0, 0.3, 0.26791506285710898257},
                         Row{1.6e-06, 4.0, 625000.0, 5.1557730770528388554e-24},
                         Row{1.6e-06, 4.0, 3000000.0, 1.8981103692454488186e-26},
                         Row{1.6e-06, 1000000.0, 0.3, 0.26791437699904731525},
                         Row{1.6e-06, 1000000.0, 625000.0, 7.6742447322457466204e-19},
                         Row{1.6e-06, 1000000.0, 3000000.0, 3.7628322997430843509e-21},
                         Row{0.0001, 0.001, 0.3, 0.26791506285717328219},
                         Row{0.0001, 0.001, 10000.0, 3.184269794774574119e-17},
                         Row{0.0001, 0.001, 3000000.0, 3.9336813892587725962e-27},
                         Row{0.0001, 4.0, 0.3, 0.26791505214325034709},
                         Row{0.0001, 4.0, 10000.0, 7.8670850054380635202e-17},
                         Row{0.0001, 4.0, 3000000.0, 1.9648582965802665958e-26},
                         Row{0.0001, 1000000.0, 0.3, 0.26526243847510141838},
                         Row{0.0001, 1000000.0, 10000.0, 1.1594057560249321791e-11},
                         Row{0.0001, 1000000.0, 3000000.0, 3.8908039082852021435e-21},
                         Row{0.3, 0.001, 0.3, 0.26789095267411176276},
                         Row{0.3, 0.001, 3.3333333333333335, 0.0021708651385730267235},
                         Row{0.3, 0.001, 3000000.0, 3.933327433492755204e-27},
                         Row{0.3, 4.0, 0.3, 0.19699636974989149858},
                         Row{0.3, 4.0, 3.3333333333333335, 0.0043853978617210922334},
                         Row{0.3, 4.0, 3000000.0, 1.4447616475284229781e-26},
                         Row{0.3, 1000000.0, 0.3, 2.9768009562099582521e-6},
                         Row{0.3, 1000000.0, 3.3333333333333335, 0.010538876688103237561},
                         Row{0.3, 1000000.0, 3000000.0, 4.3663466084023470199e-26},
                         Row{1000.0, 0.001, 0.3, 0.000306905237798217944},
                         Row{1000.0, 0.001, 0.001, 116982.68068626130477},
                         Row{1000.0, 0.001, 3000000.0, 3.9297516812804938279e-30},
                         Row{1000.0, 4.0, 0.3, 0.00003936404910086642259},
                         Row{1000.0, 4.0, 0.001, 117099.63377380945037},
                         Row{1000.0, 4.0, 3000000.0, 4.9121883735543961855e-33},
                         Row{1000.0, 1000000.0, 0.3, 0.000039297080444039500478},
                         Row{1000.0, 1000000.0, 0.001, 117099.66304852121716},
                         Row{1000.0, 1000000.0, 3000000.0, 3.9297556110291178397e-33},
                         Row{1000000.0, 0.001, 0.3, 3.0721257936501687777e-10},
                         Row{1000000.0, 0.001, 1e-06, 117099662931.53866905},
                         Row{1000000.0, 0.001, 3000000.0, 3.9336814290280928926e-36},
                         Row{1000000.0, 4.0, 0.3, 3.9364495578082151879e-11},
                         Row{1000000.0, 4.0, 1e-06, 117099663048.60905706},
                         Row{1000000.0, 4.0, 3000000.0, 4.9121896016002615272e-39},
                         Row{1000000.0, 1000000.0, 0.3, 3.9297517080292092715e-11},
                         Row{1000000.0, 1000000.0, 1e-06, 117099663048.63833186},
                         Row{1000000.0, 1000000.0, 3000000.0, 3.9297556110330475918e-39}}) {
    INFO("alpha = " << row.alpha << ", amplitude = " << row.amplitude << ", slope = " << row.slope);
    const Material m = build(distribution("velvet", {{"alpha", row.alpha}, {"amplitude", row.amplitude}}));
    CHECK(relative(std::get<Velvet>(m.surface().distribution).profile.p22(row.slope * row.slope), row.p22) < 4e-15);
  }
}

TEST_CASE("Phong: Lambda from n next to -1 on, where its mean slope is infinite, to that of a mirror") {
  struct Row {
    double exponent, theta, lambda;
  };
  for (const Row& row :
       {Row{-0.9999999999990905, 0.3, 108263177579.46587326}, Row{-0.9999999999990905, 1.0, 545069998330.0986088},
        Row{-0.9999999999990905, 1.5, 4935291398252.8245382}, Row{-0.9999999999990905, 1.57, 439499649338459.16865},
        Row{-0.9375, 0.3, 1.4352683101948413088}, Row{-0.9375, 1.0, 7.870308947200598494},
        Row{-0.9375, 1.5, 74.394210337166594768}, Row{-0.9375, 1.57, 6667.9638425537401312},
        Row{-0.5, 0.3, 0.094783876134781544793}, Row{-0.5, 1.0, 0.9240556006224665385},
        Row{-0.5, 1.5, 11.284204984210114744}, Row{-0.5, 1.57, 1047.5958356762210381},
        Row{0.5, 0.3, 0.0078127434705277428768}, Row{0.5, 1.0, 0.25948422518911210262},
        Row{0.5, 1.5, 4.8982523231104886348}, Row{0.5, 1.57, 478.42396057069860332},
        Row{1000000.0, 1.57, 0.15193170849971580839}}) {
    INFO("n = " << row.exponent << ", theta = " << row.theta);
    CHECK(relative(lambda(build(distribution("phong", {{"exponent", row.exponent}})), from_angles(row.theta, 0.4)),
                   row.lambda) < 1e-12);
  }
  for (const auto& [exponent, a, exact] :
       {std::tuple(-0.9999999999999999, 0.0, 2027332112980360.5496), std::tuple(-0.99, 0.0, 22.776573323080190278),
        std::tuple(3.0, 0.0, 0.33552808069658023357), std::tuple(2000000000000.0, 0.0, 0.28209479177398392902),
        std::tuple(3000.5, 20.0, 4.921864983021630811e-158), std::tuple(2000000000000.0, 0.001, 0.28159507386872868706),
        std::tuple(2000000000000.0, 3.0, 1.6775174889001862288e-6),
        std::tuple(2000000000000.0, 9.0, 1.1354071168910019425e-38)}) {
    const std::string text = "n = " + std::to_string(exponent) + ", a = " + std::to_string(a);
    INFO(text);
    CHECK(relative(a_lambda<Phong>(distribution("phong", {{"exponent", exponent}}), a), exact) < 2e-13);
  }
}

TEST_CASE("Phong by an alpha next to sqrt(2): n + 1 has all its digits") {
  // n + 1 = (2 - alpha^2) / alpha^2 of the double below sqrt(2), and at n = -1 a Lambda(0) is 1 / (sqrt(2) pi (n + 1)).
  const double alpha = std::nextafter(std::numbers::sqrt2, 0.0);
  const double exact = 1269464950246858.7228;
  CHECK(relative(a_lambda<Phong>(describe("phong", alpha), 0), exact) < 1e-13);
}

TEST_CASE("GTR: a Lambda(a) of sharp peaks, of normals that lie flat, and of all but even ones") {
  for (const auto& [alpha, gamma, a, exact] :
       {std::tuple(0.3, 1000.0, 0.0, 0.009360240451163803518), std::tuple(0.3, 1000.0, 0.05, 0.00013989604247426646322),
        std::tuple(0.3, 1000.0, 0.5, 2.0478754441943410358e-92), std::tuple(10.0, 900.5, 1.0, 16.338510246678931319),
        std::tuple(10.0, 900.5, 10000.0, 0.022262600190706746266),
        std::tuple(1000000.0, 0.5, 0.0, 4.5205794279762972156e-6),
        std::tuple(1000000.0, 0.5, 100.0, 1.2499934376874925428e-9),
        std::tuple(1000000.0, 1000.0, 1.0, 17.334551956257990289), std::tuple(0.0001, 0.01, 0.0, 4969.2309349846241232),
        std::tuple(0.0001, 0.01, 10000.0, 2052.0251263502863719),
        std::tuple(0.0001, 0.01, 1000000.0, 24.749384424487460205)}) {
    const std::string text =
        "alpha = " + std::to_string(alpha) + ", gamma = " + std::to_string(gamma) + ", a = " + std::to_string(a);
    INFO(text);
    CHECK(relative(a_lambda<Gtr>(distribution("gtr", {{"alpha", alpha}, {"gamma", gamma}}), a), exact) < 2e-12);
  }
}

TEST_CASE("shapes: a Lambda(a) of Gaussian tails, of two widths, of a ring, of tails that hardly end") {
  struct Row {
    const char* shape;
    double a, exact;
  };
  for (const Row& row :
       {Row{"exp(-t2)+1000*exp(-1000*t2)", 0.0, 0.14550770617732099952},
        Row{"exp(-t2)+1000*exp(-1000*t2)", 0.01, 0.14096055392319543596},
        Row{"exp(-t2)+1000*exp(-1000*t2)", 0.05, 0.12894915060629491455},
        Row{"exp(-t2)+1000*exp(-1000*t2)", 0.5, 0.049910307093561416472},
        Row{"exp(-t2)+1000*exp(-1000*t2)", 9.0, 5.6770355651395078734e-39},
        Row{"exp(-t2)+1000*exp(-1000*t2)", 14.0, 2.6981498107676831892e-89},
        Row{"t2*exp(-t2^1.1)", 0.5, 0.17957091629901103475}, Row{"t2*exp(-t2^1.1)", 3.0, 1.0578306598590526244e-6},
        Row{"t2*exp(-t2^1.1)", 14.0, 1.7520924195492224893e-146},
        Row{"t2*exp(-t2^1.1)", 16.0, 8.7040856443242024198e-196},
        Row{"exp(-1e4*t2)+1e-3*exp(-(t-5)^2*1e4)", 0.01, 1.014389546670924576},
        Row{"exp(-1e4*t2)+1e-3*exp(-(t-5)^2*1e4)", 0.5, 0.86275795903932342128},
        Row{"exp(-1e4*t2)+1e-3*exp(-(t-5)^2*1e4)", 3.0, 0.24788625725968811483},
        Row{"exp(-1e4*t2)+1e-3*exp(-(t-5)^2*1e4)", 4.9, 0.002721352670898584927},
        Row{"(1+t2)^-1.53", 0.0, 5.5226134960289250224}, Row{"(1+t2)^-1.53", 3.0, 4.872212714653656694},
        Row{"(1+t2)^-1.53", 10000000000.0, 1.308696028976107844}, Row{"(1+t2)^-1.501", 0.0, 159.37546991588583622},
        Row{"(1+t2)^-1.501", 3.0, 158.70255490112363365}}) {
    INFO(std::string(row.shape) << ", a = " << row.a);
    CHECK(relative(a_lambda<Custom>(custom(row.shape, 1), row.a), row.exact) < 1e-11);
  }
}

TEST_CASE("shapes: where a formula underflows, Lambda is wrong by no more than 1e-200") {
  // A formula of Gaussian tails is 0 from t2 = 745 on, and has lost digits from 708 on.
  for (const char* shape :
       {"exp(-t2)", "t2 * exp(-t2^1.1)", "exp(-t2) + 1000 * exp(-1000 * t2)", "exp(-t2) / (1 + t2)"})
    for (double a = 20; a < 40; a += 0.07) {
      INFO(std::string(shape) << ", a = " << a);
      const double is = a_lambda<Custom>(custom(shape, 1), a);
      CHECK(is >= 0);
      CHECK(is < 1e-160);
      if (std::string(shape) == "exp(-t2)") CHECK(std::fabs(is - BeckmannShape::a_lambda(a)) < 1e-10 * is + 1e-200);
    }
  // What it is for: integrals over directions of whose Lambda nothing is left.
  const Material m = build(custom("exp(-t2)", 0.1));
  const Estimate albedo = compute(Integral::albedo, m, from_angles(1.2, 0), 1e-9);
  const Estimate beckmann = compute(Integral::albedo, material("beckmann", 0.1), from_angles(1.2, 0), 1e-9);
  CHECK(std::fabs(albedo.value - beckmann.value) < 2e-9);
}

TEST_CASE("tables of Lambda: 1e-10 of it down to 1e-290") {
  for (const auto& [type, key, parameter, a, exact] :
       {std::tuple("exponential_power", "p", 1.0, 9.0, 1.1354071130279015747e-38),
        std::tuple("exponential_power", "p", 1.0, 14.5, 3.2594267674254262956e-95),
        std::tuple("exponential_power", "p", 1.0, 20.0, 6.7280743590952235889e-178),
        std::tuple("exponential_power", "p", 1.0, 24.0, 1.7147209504443964041e-254),
        std::tuple("exponential_power", "p", 0.1, 1000.0, 75980.012228785544562),
        std::tuple("exponential_power", "p", 0.1, 100000000000.0, 6.7120734612446090147e-47),
        std::tuple("exponential_power", "p", 0.1, 3000000000000.0, 2.6304252553218694648e-110),
        std::tuple("exponential_power", "p", 10.0, 1.2, 1.8031743196125666201e-24),
        std::tuple("exponential_power", "p", 10.0, 1.3, 5.8742737632193410865e-92),
        std::tuple("exponential_power", "p", 10.0, 1.35, 9.2722163869740511806e-186),
        std::tuple("ward", "alpha", 0.1, 9.0, 8.4238649355868140665e-39),
        std::tuple("ward", "alpha", 0.1, 14.5, 1.8522369139321814839e-95),
        std::tuple("ward", "alpha", 0.1, 24.0, 6.6155386733495766687e-255),
        std::tuple("ward", "alpha", 1000.0, 0.5, 0.044748081580385125294),
        std::tuple("ward", "alpha", 1000.0, 14.5, 1.2622269200423633335e-96),
        std::tuple("ward", "alpha", 1000.0, 24.0, 4.0267893290258725378e-256),
        std::tuple("gaussian", "alpha", 0.07, 9.0, 2.1921240748809573733e-31),
        std::tuple("gaussian", "alpha", 0.07, 14.0, 7.3244844124535026053e-57),
        std::tuple("gaussian", "alpha", 0.07, 20.0, 9.7221301578093797499e-84),
        std::tuple("gaussian", "alpha", 0.07, 1000.0, 2.4848255960525506658e-216),
        std::tuple("gaussian", "alpha", 0.07, 1e+20, 2.1282307894912212303e-235)}) {
    const std::string text =
        std::string(type) + ", " + key + " = " + std::to_string(parameter) + ", a = " + std::to_string(a);
    INFO(text);
    TermDescription description = describe(type, std::string(key) == "alpha" ? parameter : 1);
    description.distribution.values.set(key, parameter);
    const std::string name = type;
    const double is = name == "ward"       ? a_lambda<Ward>(description, a)
                      : name == "gaussian" ? a_lambda<Gaussian>(description, a)
                                           : a_lambda<ExponentialPower>(description, a);
    CHECK(relative(is, exact) < 1e-11);
  }
}
