using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Looks for what lies over the picture, such as another mod's display or a frame-rate counter: the camera of the frozen world is moved
/// far, and edges that stay where they are cannot belong to the world.
/// </summary>
internal sealed class DisplayCheck(SelfTestContext context) : SelfCheck(context)
{
    /// <summary>
    /// Places of the camera, vehicle frame, metres: high above the ground, so that near and far things move by many pixels.
    /// </summary>
    private static readonly Vector3D[] Places = [new(0, 0, 6), new(3, 0, 12), new(-3, 5, 20), new(0, -5, 30)];

    public override string Title => "displays of other programs";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Display];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Context.Lines.Any(line => line.Check == SelfTestChecks.Hud && line.Verdict == SelfTestVerdict.Problem))
        {
            throw new SelfTestException("the game's own display cannot be hidden.");
        }

        if (Game.MountedCamera is not { } camera || Context.BestFreeze is not { MovesCamera: true })
        {
            throw new SelfTestException("the camera cannot be moved in the frozen world.");
        }

        Game.Hud?.Hide();
        yield return WorkStep.Do(Freeze());

        var edges = new StaticEdges(Context.Options.Image);
        foreach (Vector3D place in Places)
        {
            camera.Shift(place);
            yield return WorkStep.Do(Wait(Context.PictureTicks + 1));

            PixelBuffer picture = Context.Grab();
            edges.Add(picture);
            Context.Keep("display-" + edges.Pictures.ToString(CultureInfo.InvariantCulture), picture);
        }

        if (edges.Region is { } region)
        {
            Context.Add(
                SelfTestChecks.Display,
                SelfTestVerdict.Problem,
                $"Something is drawn over the picture ({region}): close the other program, or switch the other mod's display off."
            );
        }
        else
        {
            Context.Add(SelfTestChecks.Display, SelfTestVerdict.Good, $"Nothing is drawn over the picture.");
        }
    }

    public override void Release() => Game.MountedCamera?.Shift(Vector3D.Zero);
}
