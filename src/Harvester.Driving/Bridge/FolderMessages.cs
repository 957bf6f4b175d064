using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The text files with which a client of the shared folder drives: indicators.txt with thirteen numbers, controls.txt with three (steering,
/// throttle, brake). Numbers have a decimal point and are separated by blanks or line ends. One further number is the frame that is
/// answered. The file must end with a line feed: a truncated file might have 0.2 for 0.25.
/// </summary>
internal static class FolderMessages
{
    private const int ControlsCount = 3;

    public static ClientMessage ParseIndicators(string text)
    {
        double[] numbers = Numbers(text, IndicatorTable.Count, "indicators.txt");
        return ClientMessageParser.IndicatorsOf(
            [.. new ArraySegment<double>(numbers, 0, IndicatorTable.Count)],
            FrameOf(numbers, IndicatorTable.Count)
        );
    }

    public static ClientMessage ParseControls(string text)
    {
        double[] numbers = Numbers(text, ControlsCount, "controls.txt");
        return new ControlsMessage(new DrivingControls(numbers[0], numbers[1], numbers[2]), FrameOf(numbers, ControlsCount));
    }

    private static long? FrameOf(double[] numbers, int count) =>
        numbers.Length > count ? ClientMessageParser.FrameOf(numbers[count]) : null;

    private static double[] Numbers(string text, int count, string file)
    {
        if (!text.EndsWith("\n", StringComparison.Ordinal))
        {
            throw new BridgeException($"{file} has no final line feed, so it may be incomplete.");
        }

        string[] words = text.Split([' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != count && words.Length != count + 1)
        {
            throw new BridgeException(FormattableString.Invariant($"{file} has {words.Length} numbers; {count} are expected."));
        }

        return Array.ConvertAll(
            words,
            word =>
                double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && Math.Abs(number) <= 1e15
                    ? number
                    : throw new BridgeException($"{file}: {ClientText.Quoted(word)} is not a number.")
        );
    }
}
