using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Tests.Lanes;

public sealed class LookAheadTests
{
    [Theory]
    [InlineData("10")]
    [InlineData("0")]
    [InlineData("2.5")]
    [InlineData("1.5s")]
    public void Parse_reads_what_ToString_writes(string text) => Assert.Equal(text, LookAhead.Parse(text)?.ToString());

    [Theory]
    [InlineData("")]
    [InlineData("s")]
    [InlineData("-1")]
    [InlineData("1m")]
    [InlineData("NaN")]
    [InlineData("Infinity")]
    public void Parse_of_another_text_is_null(string text) => Assert.Null(LookAhead.Parse(text));
}
