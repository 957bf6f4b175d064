using Harvester.Play.Screen;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Tests.Screen;

/// <summary>A desktop with one window of process 7, which a test moves, also in the middle of a copy.</summary>
internal sealed class ScriptedDesktop : IDesktop
{
    public const int Process = 7;

    public DesktopRectangle Client { get; set; } = new(-50, 20, 30, 80);

    public bool IsMinimised { get; set; }

    public DisplayFacts Facts { get; set; }

    public bool CanCopy { get; set; } = true;

    public bool IsBlack { get; set; }

    public Action DuringCopy { get; set; } = () => { };

    public DesktopView Observe() =>
        new(
            [new TopLevelWindow(1, Process, IsApplication: true, IsMinimised, ShowsNothing: false, Client, Client, Client.Area)],
            [new DesktopRectangle(-1000, 0, 1000, 1000)]
        );

    public DisplayFacts FactsOf(long window) => Facts;

    public bool TryCopy(DesktopRectangle area, PixelBuffer target)
    {
        Assert.Equal((area.Width, area.Height), (target.Size.Width, target.Size.Height));
        for (int i = 0; i < target.Bytes.Length; i++)
        {
            target.Bytes[i] = IsBlack ? (byte)0 : (byte)(area.Left + area.Top + i);
        }

        DuringCopy();
        return CanCopy;
    }
}
