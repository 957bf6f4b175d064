using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FolderMessagesTests
{
    private const string Controls = "-0.25 0.5 0.125 31\n";
    private const string Indicators = "0.1 -7 3.5 7 75 75\n-6 -2 2 6\n60 60 60.5\n31\n";

    [Fact]
    public void Truncated_controls_are_refused()
    {
        Assert.Equal(new ControlsMessage(new DrivingControls(-0.25, 0.5, 0.125), 31), FolderMessages.ParseControls(Controls));
        Assert.All(
            Enumerable.Range(0, Controls.Length),
            length => Assert.Throws<BridgeException>(() => FolderMessages.ParseControls(Controls[..length]))
        );
    }

    [Fact]
    public void Truncated_indicators_are_ignored_until_all_13_have_arrived()
    {
        double[] whole = [0.1, -7, 3.5, 7, 75, 75, -6, -2, 2, 6, 60, 60, 60.5];
        int withoutFrame = Indicators.Length - "31\n".Length;
        for (int length = 0; length < Indicators.Length; length++)
        {
            string cut = Indicators[..length];
            if (length == withoutFrame)
            {
                var message = Assert.IsType<IndicatorsMessage>(FolderMessages.ParseIndicators(cut));
                Assert.Equal(whole, message.Values);
                Assert.Null(message.Frame);
            }
            else
            {
                Assert.Throws<BridgeException>(() => FolderMessages.ParseIndicators(cut));
            }
        }
    }

    [Fact]
    public void Windows_line_endings_are_accepted() =>
        Assert.Equal(new ControlsMessage(new DrivingControls(0, 0, 1), null), FolderMessages.ParseControls("0\r\n0\r\n1\r\n"));

    [Theory]
    [InlineData("NaN 0 0\n")]
    [InlineData("Infinity 0 0\n")]
    [InlineData("1e308 0 0\n")]
    [InlineData("0,5 0 0\n")]
    [InlineData("0 0 0 -1.5\n")]
    [InlineData("0 0 0 -1\n")]
    [InlineData("0 0 0 1.5\n")]
    [InlineData("0 0 0 1e15 7\n")]
    [InlineData("0 0 0 NaN\n")]
    [InlineData("\n")]
    public void Numbers_that_are_not_valid_are_refused(string text) =>
        Assert.Throws<BridgeException>(() => FolderMessages.ParseControls(text));
}
