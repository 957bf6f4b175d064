using Harvester.Reports.Sessions;

namespace Harvester.Reports.Tests.Sessions;

public sealed class EvenSelectionTests
{
    [Theory]
    [InlineData(0, 5, new int[0])]
    [InlineData(1, 5, new[] { 0 })]
    [InlineData(3, 5, new[] { 0, 1, 2 })]
    [InlineData(9, 1, new[] { 0 })]
    [InlineData(9, 2, new[] { 0, 8 })]
    [InlineData(9, 3, new[] { 0, 4, 8 })]
    [InlineData(10, 4, new[] { 0, 3, 6, 9 })]
    public void Of_takes_first_and_last_and_even_steps_between(int count, int most, int[] expected) =>
        Assert.Equal(expected, EvenSelection.Of(count, most));

    [Fact]
    public void Of_many_does_not_overflow() => Assert.Equal([0, 1_000_000_000, 2_000_000_000], EvenSelection.Of(2_000_000_001, 3));
}
