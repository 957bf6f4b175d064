using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the scene of a frame, as docs/relabel.md describes it. Time and weather come from the label.</summary>
internal static class SceneParser
{
    /// <exception cref="DatasetFormatException">The file is not a valid scene; the message names the field, not the file.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static RecordedScene Read(string path, FrameLabel label)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            return Parse(new JsonFields(document.RootElement), label);
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InLine(e), e);
        }
    }

    private static RecordedScene Parse(JsonFields scene, FrameLabel label)
    {
        JsonFields camera = scene.Fields("camera");
        JsonFields lens = scene.Fields("lens");
        JsonFields ego = scene.Fields("ego");
        IReadOnlyList<JsonFields> entities = scene.List("entities");
        var snapshot = new SceneSnapshot(
            label.GameFrame,
            label.TimeSeconds,
            new CameraState(PoseOf(camera), camera.Number("verticalFovDegrees"), camera.Number("nearClip"), camera.Number("windowAspect")),
            new EgoState(ego.Integer("handle"), ego.Text("model"), PoseOf(ego), ego.Vector("velocity"))
            {
                ModelMin = ego.Vector("modelMin"),
                ModelMax = ego.Vector("modelMax"),
                HeightAboveGroundMetres = ego.OptionalNumber("heightAboveGround"),
                Motion = EgoMotionParser.Parse(ego),
            },
            [.. entities.Select(EntityOf)],
            label.Environment
        );
        Dictionary<int, int> ids = IdsOf(entities);
        RecordedOcclusion[] occlusions = [.. scene.List("occlusions").Select(OcclusionOf)];
        HashSet<int> handles = [.. snapshot.Entities.Select(entity => entity.Handle)];
        return occlusions.FirstOrDefault(found => !handles.Contains(found.Handle)) is { } stray
            ? throw new DatasetFormatException($"occlusions: {stray.Handle} is not the handle of an entity.")
            : new RecordedScene(
                snapshot,
                lens.Checked(() =>
                    new Lens(
                        lens.Number("focalScale"),
                        lens.Number("centreOffsetX"),
                        lens.Number("centreOffsetY"),
                        lens.Number("k1"),
                        lens.Number("k2")
                    )
                ),
                ids,
                occlusions
            )
            {
                // Scenes of earlier versions have none.
                Distant = scene.Has("distant") ? [.. scene.List("distant").Select(DistantOf)] : [],
            };
    }

    private static Dictionary<int, int> IdsOf(IReadOnlyList<JsonFields> entities)
    {
        var handles = new HashSet<int>();
        var ids = new Dictionary<int, int>();
        foreach (JsonFields entity in entities)
        {
            int handle = entity.Integer("handle");
            if (!handles.Add(handle))
            {
                throw new DatasetFormatException($"entities: two have the handle {handle}.");
            }

            if (entity.Has("id"))
            {
                ids.Add(handle, entity.Integer("id"));
            }
        }

        return ids;
    }

    private static EntityState EntityOf(JsonFields entity) =>
        new(
            entity.Integer("handle"),
            entity.Name<ObjectClass>("class"),
            entity.Text("model"),
            PoseOf(entity),
            entity.Vector("modelMin"),
            entity.Vector("modelMax"),
            entity.Vector("velocity")
        )
        {
            HasRider = entity.OptionalBoolean("hasRider"),
            VehicleHandle = entity.Has("vehicle") ? entity.Integer("vehicle") : null,
            Lights = VehicleLightsParser.Parse(entity),
            Skeleton = entity.Has("joints") ? SkeletonOf(entity) : null,
        };

    private static Skeleton SkeletonOf(JsonFields entity)
    {
        Vector3D[] joints = entity.Vectors("joints");
        return entity.Checked(() => new Skeleton(joints));
    }

    private static DistantEntity DistantOf(JsonFields entity) => new(EntityOf(entity), entity.Name<Sight>("sight"));

    private static RecordedOcclusion OcclusionOf(JsonFields found) =>
        new(
            found.Integer("handle"),
            found.Has("face") ? found.Integer("face") : null,
            found.Integer("id"),
            found.Name<Sight>("sight"),
            found.Name<OcclusionMethod>("method"),
            found.Number("occludedFraction"),
            found.Has("setLight") ? found.Name<LightState>("setLight") : null
        );

    private static Pose PoseOf(JsonFields fields) => new(fields.Vector("position"), fields.Axes());
}
