using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>Casts rays through a grid of pixels of the frozen world: the materials they report, and what readings and rays cost.</summary>
internal sealed class RayCheck(SelfTestContext context) : SelfCheck(context)
{
    private const int Columns = 20;
    private const int Rows = 10;

    /// <summary>Fewer hits say little.</summary>
    private const int MinHits = 20;

    public override string Title => "materials, and the cost of rays";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Materials, SelfTestChecks.Cost];

    public override IEnumerable<WorkStep> Run()
    {
        yield return WorkStep.Do(Freeze());

        long natives = Game.Calls?.Natives ?? 0;
        double begin = Game.Clock.Milliseconds;
        SceneSnapshot scene = Context.Reader.Read();
        double readMilliseconds = Game.Clock.Milliseconds - begin;
        long readNatives = (Game.Calls?.Natives ?? 0) - natives;
        yield return WorkStep.Tick;

        CameraState state = scene.Camera;
        var camera = new Camera(
            state.Pose,
            new CameraIntrinsics(state.VerticalFovDegrees, Context.Options.Image, state.WindowAspect, state.NearClip, Context.Options.Lens)
        );
        var hits = new List<RayHit>();
        double milliseconds = 0;
        for (int row = 0; row < Rows; row++)
        {
            begin = Game.Clock.Milliseconds;
            for (int column = 0; column < Columns; column++)
            {
                double u = (column + 0.5) / Columns * Context.Options.Image.Width;
                double v = (row + 0.5) / Rows * Context.Options.Image.Height;
                if (Game.Rays.Cast(camera.RayThrough(u, v), Context.Options.RangeMetres, scene.Ego.Handle) is { } hit)
                {
                    hits.Add(hit);
                }
            }

            milliseconds += Game.Clock.Milliseconds - begin;
            yield return WorkStep.Tick;
        }

        Context.Add(
            SelfTestChecks.Cost,
            SelfTestVerdict.Good,
            $"A reading of {scene.Entities.Count} entities takes {readNatives} natives and {readMilliseconds:0.0} ms; ",
            FormattableString.Invariant($"a ray takes {milliseconds / (Columns * Rows):0.000} ms.")
        );
        Judge(hits);
        Context.AddUntested(Checks, "too few rays hit anything.");
    }

    private void Judge(List<RayHit> hits)
    {
        if (hits.Count >= MinHits)
        {
            int known = hits.Count(hit => hit.Material != 0);
            int kinds = hits.Where(hit => hit.Material != 0).Select(hit => hit.Material).Distinct().Count();
            Context.Add(
                SelfTestChecks.Materials,
                2 * known >= hits.Count ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
                $"{known} of {hits.Count} rays report a material, of {kinds} kinds."
            );
        }
    }
}
