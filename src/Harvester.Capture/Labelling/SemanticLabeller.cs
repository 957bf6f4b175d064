using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.ClassMaps;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes the class map of a frame: objects by the mask, the rest by the materials that rays report, markings by the paint that the game
/// knows. In a simulated game the renderer may give all classes instead.
/// </summary>
internal sealed class SemanticLabeller(LabellingOptions options, FrameRays rays, IRoadPaint? paint, ISurfaceTruth? truth) : IChannelLabeller
{
    /// <summary>Maximum rays of a class map, as a fraction of the pixels.</summary>
    private const double MaxRayFraction = 0.02;

    /// <summary>Paint farther away is too thin to be seen, metres.</summary>
    private const double PaintRange = 150;

    /// <summary>Points of paint are half a metre apart, and a dash continues by half of that beyond the last of them, metres.</summary>
    private const double PaintEnd = 0.25;

    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.AfterObjects;

    /// <inheritdoc />
    public string RaysKey => FrameChannels.ClassMaps.RaysKey;

    /// <inheritdoc />
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        Dictionary<int, SemanticClass> entities = EntityClasses(draft.Snapshot);
        if (options.Semantics == SemanticsMethod.Exact && truth is not null)
        {
            draft.Add(new ClassMapPart(truth.Draw(options.Image, handle => ClassOf(entities, handle)), SemanticsMethod.Exact, 0, 0));
            yield break;
        }

        Camera camera = draft.Camera;
        int egoHandle = draft.Snapshot.Ego.Handle;
        int budget = Math.Min(rays.Left, (int)(MaxRayFraction * camera.Image.PixelCount));
        var mapper = new ClassMapper(camera.Image, ObjectPixels(draft), SampleAt, HorizonRow(camera), budget);
        while (mayCastRays() && mapper.Step())
        {
            yield return WorkStep.Pause;
        }

        (InstanceMap map, int interpolated) = mapper.Finish();
        if (paint is not null)
        {
            new MarkingPainter(camera, map, (ushort)SemanticClass.Road, (ushort)SemanticClass.LaneMarking).Paint(
                paint.Near(camera.Pose.Position, PaintRange),
                PaintEnd
            );
        }

        draft.Add(new ClassMapPart(map, SemanticsMethod.Rays, mapper.RaysCast, interpolated));

        byte SampleAt(int column, int row)
        {
            RayHit? hit = rays.Cast(camera.RayThrough(column + 0.5, row + 0.5), ExhaustivePixelMapper.RayLength, egoHandle);
            return (byte)(
                hit is not { } met ? SemanticClass.Sky
                : met.Entity == RayHit.World ? options.Materials.ClassOf(met.Material, met.NormalZ)
                : ClassOf(entities, met.Entity)
            );
        }
    }

    private static SemanticClass ClassOf(Dictionary<int, SemanticClass> entities, int handle) =>
        entities.TryGetValue(handle, out SemanticClass found) ? found : SemanticClass.Other;

    private static Dictionary<int, SemanticClass> EntityClasses(SceneSnapshot snapshot)
    {
        var classes = new Dictionary<int, SemanticClass>();
        foreach (EntityState entity in snapshot.Entities.Concat(snapshot.Distant))
        {
            classes[entity.Handle] = SemanticClasses.Of(entity.Class);
        }

        return classes;
    }

    private static byte[] ObjectPixels(FrameDraft draft)
    {
        byte[] given = new byte[draft.Camera.Image.PixelCount];
        if (draft.Mask is { } mask)
        {
            Dictionary<ushort, byte> classes = draft.Objects.ToDictionary(
                label => (ushort)label.Id,
                label => (byte)SemanticClasses.Of(label.Class)
            );
            for (int i = 0; i < given.Length; i++)
            {
                classes.TryGetValue(mask.Ids[i], out given[i]);
            }
        }

        return given;
    }

    /// <summary>The row where the level direction ahead is seen; -1 if the camera looks straight up or down.</summary>
    private static int HorizonRow(Camera camera)
    {
        const double far = 1e5;
        Vector3D forward = camera.Pose.Axes.Forward with { Z = 0 };
        return
            forward.Length > 0
            && camera.Project(camera.Pose.Position + (forward.Normalized() * far))
                is { Outcome: not ProjectionOutcome.BehindNearPlane } seen
            ? (int)Math.Max(-far, Math.Min(far, seen.V))
            : -1;
    }
}
