using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Windows;

/// <summary>What a case claims; a false claim throws.</summary>
internal static class Expect
{
    /// <summary>A grab is good and shows the window's pattern in every pixel.</summary>
    public static void Shows(PatternWindow window, IScreen screen) => Shows(window.Client, window.Pattern, screen);

    /// <summary>A grab is good and shows a pattern in every pixel.</summary>
    public static void Shows(Area client, Pattern pattern, IScreen screen)
    {
        PatternWindow.AwaitOnScreen(client, pattern);
        var buffer = new PixelBuffer(new(client.Width, client.Height));
        Good(screen.Grab(buffer));
        for (int y = 0, i = 0; y < client.Height; y++)
        {
            for (int x = 0; x < client.Width; x++)
            {
                for (int channel = 0; channel < PixelBuffer.BytesPerPixel; channel++, i++)
                {
                    byte expected = pattern.Channel(channel, x, y);
                    That(
                        buffer.Bytes[i] == expected,
                        $"pixel ({x}, {y}) channel {channel} is {buffer.Bytes[i]}, the window shows {expected}"
                    );
                }
            }
        }
    }

    /// <summary>A grab is refused for a reason.</summary>
    public static void Refused(string reason, IScreen screen)
    {
        GrabResult result = screen.Grab(new PixelBuffer(new(64, 48)));
        That(result.Refusal == reason, $"expected the refusal {reason}, got {result.Refusal ?? "a picture"}");
    }

    /// <summary>A text is the expected one.</summary>
    public static void Says(string expected, string actual) => That(actual == expected, $"expected '{expected}', got '{actual}'");

    public static void Good(GrabResult result) => That(result.IsGood, $"expected a picture, got the refusal {result.Refusal}");

    public static void That(bool claim, string otherwise)
    {
        if (!claim)
        {
            throw new InvalidOperationException(otherwise);
        }
    }
}
