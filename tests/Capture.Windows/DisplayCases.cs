using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;

namespace Harvester.Capture.Windows;

/// <summary>What Windows reports about the display. The monitors of the tests do not show HDR.</summary>
internal static class DisplayCases
{
    public static IEnumerable<CaptureCase> All =>
        [new("HDR is asked of each monitor, and none has it", NoHdr), new("the window's description names no HDR", Description)];

    private static void NoHdr() => Expect.That(AdvancedColour.IsOnAnyMonitor() != true, "a monitor is reported to show HDR");

    private static void Description()
    {
        using var window = new PatternWindow(new(32, 24, 800, 600), Pattern.Distinct(12));
        window.AwaitOnScreen();
        using var screen = GameWindowScreen.OfThisProcess();
        string description = screen.Describe();
        Expect.That(description.StartsWith("800 x 600, ", StringComparison.Ordinal), $"the description is {description}");
        Expect.That(!description.Contains(WindowDescription.Hdr, StringComparison.Ordinal), $"the description is {description}");
    }
}
