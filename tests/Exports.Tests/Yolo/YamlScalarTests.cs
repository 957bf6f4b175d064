using Harvester.Exports.Formats.Yolo;

namespace Harvester.Exports.Tests.Yolo;

public sealed class YamlScalarTests
{
    [Theory]
    [InlineData("car")]
    [InlineData("Person_sitting")]
    [InlineData("sign-R1-1")]
    [InlineData("traffic light")]
    [InlineData("none")]
    public void Word_that_yaml_reads_as_a_string_is_plain(string text) => Assert.Equal(text, YamlScalar.Of(text));

    [Theory]
    [InlineData("no")]
    [InlineData("Yes")]
    [InlineData("OFF")]
    [InlineData("y")]
    [InlineData("null")]
    [InlineData("true")]
    [InlineData("12")]
    [InlineData("1e3")]
    [InlineData("0x1F")]
    [InlineData("2020-01-02")]
    [InlineData("-1")]
    [InlineData("- car")]
    [InlineData("_")]
    [InlineData("")]
    [InlineData("a: b")]
    [InlineData("car ")]
    public void Word_that_yaml_reads_otherwise_is_quoted(string text) => Assert.Equal($"'{text}'", YamlScalar.Of(text));

    [Fact]
    public void Apostrophe_is_doubled() => Assert.Equal("'driver''s car'", YamlScalar.Of("driver's car"));
}
