using System.Globalization;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Text;

/// <summary>Numbers of scenes read back as the same doubles, so that labels can be recomputed from them.</summary>
public sealed class ExactNumberTests
{
    [Theory]
    [InlineData(0.1)]
    [InlineData(1.0 / 3)]
    [InlineData(-27.02508641172149)]
    [InlineData(3.290789553800667E-12)]
    [InlineData(double.MaxValue)]
    [InlineData(double.Epsilon)]
    [InlineData(0.84551240822557006)]
    public void Exact_reads_back_as_the_same_double(double value) =>
        Assert.Equal(value, double.Parse(new JsonText().Exact(value).ToString(), CultureInfo.InvariantCulture));

    [Fact]
    public void Exact_writes_minus_zero_as_zero() => Assert.Equal("0", new JsonText().Exact(-0.0).ToString());
}
