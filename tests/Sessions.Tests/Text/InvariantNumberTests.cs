using System.Globalization;
using FsCheck;
using FsCheck.Fluent;
using Harvester.Sessions.Text;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Text;

public sealed class InvariantNumberTests
{
    [Theory]
    [InlineData(0, 4, "0")]
    [InlineData(-0.0, 4, "0")]
    [InlineData(-0.001, 2, "0")]
    [InlineData(0.125, 2, "0.13")]
    [InlineData(-0.125, 2, "-0.13")]
    [InlineData(0.3, 3, "0.3")]
    [InlineData(1.005, 0, "1")]
    [InlineData(12.5, 4, "12.5")]
    [InlineData(-3200.00049, 3, "-3200")]
    [InlineData(0.99996, 4, "1")]
    [InlineData(0.0007, 4, "0.0007")]
    [InlineData(1_000_000, 3, "1000000")]
    [InlineData(0.707106781, 9, "0.707106781")]
    [InlineData(1e-300, 12, "0")]
    public void Format_value_gives_text(double value, int decimals, string expected) =>
        Assert.Equal(expected, InvariantNumber.Format(value, decimals));

    [Fact]
    public void Format_random_values_is_within_half_of_the_last_decimal()
    {
        Arbitrary<(int Power, int Decimals)> scales = Arb.Zip(RandomCases.Integer(-3, 6), RandomCases.Integer(0, 7));
        RandomCases.Check(
            10_000,
            Arb.Zip(RandomCases.Number(-0.5, 0.5), scales),
            drawn =>
            {
                double value = drawn.Item1 * Math.Pow(10, drawn.Item2.Power);
                int decimals = drawn.Item2.Decimals;
                decimal read = decimal.Parse(InvariantNumber.Format(value, decimals), CultureInfo.InvariantCulture);

                // The product with the power of ten rounds once more: a few units in the 16th place of the value.
                decimal halfStep = (decimal)(0.5 * Math.Pow(10, -decimals)) + ((decimal)Math.Abs(value) * 1e-15m);
                Assert.InRange(Math.Abs(read - (decimal)value), 0, halfStep + 1e-15m);
            }
        );
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(1e13)]
    public void Format_refuses_numbers_that_cannot_be_written(double value) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => InvariantNumber.Format(value, 4));

    [Theory]
    [InlineData(-1)]
    [InlineData(13)]
    public void Format_refuses_impossible_numbers_of_decimals(int decimals) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => InvariantNumber.Format(1, decimals));
}
