using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Work;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the instance mask of a frame, from photographs or from rays. Rays pass through the camera's vehicle.</summary>
/// <param name="options">What to label.</param>
/// <param name="rays">The ray caster.</param>
internal sealed class MaskMaker(LabellingOptions options, FrameRays rays)
{
    /// <summary>Compares masks of both methods; null if they are not compared.</summary>
    public MaskComparison? Comparison { get; init; }

    /// <summary>Makes the mask of a frame, in steps.</summary>
    /// <param name="frame">The frame; its targets are in the mask.</param>
    /// <param name="mayCastRays">Called before each ray.</param>
    /// <param name="pictures">The photographs for a coded mask; null for a mask from rays.</param>
    /// <param name="made">Receives the mask.</param>
    public IEnumerable<WorkStep> Make(FrameDraft frame, Func<bool> mayCastRays, CodedPictures? pictures, WorkResult<MadeMap> made)
    {
        rays.Begin(RayPhase.Map);
        MadeMap? coded = null;
        if (pictures is not null)
        {
            var maker = new CodedMapMaker(options, frame.Camera, frame.Targets, frame.Snapshot.Ego.Handle, rays, pictures);
            yield return WorkStep.Do(maker.Make(mayCastRays));
            coded = maker.Made;
        }

        MadeMap? fromRays = null;
        if (coded is null || Comparison is not null)
        {
            var mapper = new AdaptivePixelMapper(
                frame.Camera,
                frame.Targets,
                frame.Snapshot.Ego.Handle,
                rays,
                new PixelMapOptions { RayBudget = rays.Left, RayReachMetres = options.RayReachMetres }
            );
            while (mayCastRays() && mapper.Step())
            {
                yield return WorkStep.Pause;
            }

            fromRays = MadeMap.Of(mapper.Finish());
        }

        if (coded is not null && fromRays is not null)
        {
            Comparison!.Add(frame.Candidates, coded.Map, fromRays.Map);
        }

        made.Value = coded ?? fromRays!;
        yield return WorkStep.Pause;
    }
}
