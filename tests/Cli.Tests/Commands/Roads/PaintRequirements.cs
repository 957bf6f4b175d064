using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>What is required of measured paint by day in clear weather: metres, and shares of the length of the lines.</summary>
internal static class PaintRequirements
{
    public const double Max95 = 0.10;
    private const double MaxMedian = 0.03;
    private const double MinStyle = 0.98;
    private const double MinColour = 0.99;
    private const double MaxFalsePerKm = 0.5;

    public static void AssertMet(PaintJudge judge, ITestOutputHelper output)
    {
        judge.Faults.ForEach(output.WriteLine);
        Assert.InRange(judge.MedianError, 0, MaxMedian);
        Assert.InRange(judge.Error95, 0, Max95);
        Assert.InRange(judge.StyleShare, MinStyle, 1);
        Assert.InRange(judge.ColourShare, MinColour, 1);
        Assert.InRange(judge.FalseLinesPerKm, 0, MaxFalsePerKm);
    }
}
