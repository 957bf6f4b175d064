using Harvester.Capture.Harvesting;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>Shows and hides the game's own display in the frozen world, and compares the pictures.</summary>
internal sealed class HudCheck(SelfTestContext context) : SelfCheck(context)
{
    public override string Title => "hiding the game's display";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Hud];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Game.Hud is not { } hud)
        {
            throw new SelfTestException("this game has no display of its own.");
        }

        yield return WorkStep.Do(Freeze());

        var pictures = new List<PixelBuffer>();
        for (int number = 0; number < 3; number++)
        {
            (number == 1 ? hud.Restore : new Action(hud.Hide))();
            yield return WorkStep.Do(Wait(Context.PictureTicks));

            pictures.Add(Context.Grab());
        }

        Context.Keep("hud-hidden", pictures[2]);
        if (DisplayPixels.Region(pictures[0], pictures[1], pictures[2]) is { } region)
        {
            Context.Add(SelfTestChecks.Hud, SelfTestVerdict.Good, $"The game's display is hidden while the world is frozen ({region}).");
        }
        else if (hud.IsWanted == true)
        {
            Context.Add(
                SelfTestChecks.Hud,
                SelfTestVerdict.Problem,
                $"The game's display stays in the picture while the world is frozen. Switch radar and HUD off in the game's settings."
            );
        }
        else
        {
            Context.Add(SelfTestChecks.Hud, SelfTestVerdict.Good, $"The game shows no display of its own.");
        }
    }

    public override void Release() => Game.Hud?.Hide();
}
