using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes a scene from which labels can be recomputed; numbers read back as the same doubles. Fields: docs/relabel.md.</summary>
internal static class SceneJson
{
    public static string Text(RecordedScene scene)
    {
        SceneSnapshot snapshot = scene.Snapshot;
        var json = new JsonText();
        json.BeginObject().Key("camera").BeginObject();
        Append(json, snapshot.Camera.Pose)
            .Key("verticalFovDegrees")
            .Exact(snapshot.Camera.VerticalFovDegrees)
            .Key("nearClip")
            .Exact(snapshot.Camera.NearClip)
            .Key("windowAspect")
            .Exact(snapshot.Camera.WindowAspect)
            .EndObject()
            .Key("lens")
            .BeginObject()
            .Key("focalScale")
            .Exact(scene.Lens.FocalScale)
            .Key("centreOffsetX")
            .Exact(scene.Lens.CentreOffsetX)
            .Key("centreOffsetY")
            .Exact(scene.Lens.CentreOffsetY)
            .Key("k1")
            .Exact(scene.Lens.K1)
            .Key("k2")
            .Exact(scene.Lens.K2)
            .EndObject()
            .Key("ego")
            .BeginObject()
            .Key("handle")
            .Integer(snapshot.Ego.Handle)
            .Key("model")
            .String(snapshot.Ego.Model);
        Append(json, snapshot.Ego.Pose)
            .Key("modelMin")
            .Exact(snapshot.Ego.ModelMin)
            .Key("modelMax")
            .Exact(snapshot.Ego.ModelMax)
            .Key("heightAboveGround")
            .Exact(snapshot.Ego.HeightAboveGroundMetres)
            .Key("velocity")
            .Exact(snapshot.Ego.Velocity);
        if (snapshot.Ego.Motion is { } motion)
        {
            EgoMotionJson.AppendExact(json, motion);
        }

        json.EndObject().Key("entities").BeginArray();
        foreach (EntityState entity in snapshot.Entities)
        {
            json.BeginObject()
                .Key("handle")
                .Integer(entity.Handle)
                .Key("id")
                .Integer(scene.Ids.TryGetValue(entity.Handle, out int id) ? id : null);
            Append(json, entity).EndObject();
        }

        json.EndArray().Key("occlusions").BeginArray();
        foreach (RecordedOcclusion found in scene.Occlusions)
        {
            json.BeginObject()
                .Key("handle")
                .Integer(found.Handle)
                .Key("face")
                .Integer(found.Face)
                .Key("id")
                .Integer(found.Id)
                .Key("sight")
                .String(JsonName.Of(found.Sight))
                .Key("method")
                .String(JsonName.Of(found.Method))
                .Key("occludedFraction")
                .Exact(found.OccludedFraction)
                .Key("setLight")
                .String(found.SetLight is { } state ? JsonName.Of(state) : null)
                .EndObject();
        }

        json.EndArray().Key("distant").BeginArray();
        foreach (DistantEntity distant in scene.Distant)
        {
            json.BeginObject().Key("handle").Integer(distant.Entity.Handle);
            Append(json, distant.Entity).Key("sight").String(JsonName.Of(distant.Sight)).EndObject();
        }

        return json.EndArray().EndObject() + "\n";
    }

    private static JsonText Append(JsonText json, EntityState entity)
    {
        if (entity.Skeleton is { } skeleton)
        {
            json.Key("joints").BeginArray();
            foreach (Vector3D joint in skeleton.Joints)
            {
                json.Exact(joint);
            }

            json.EndArray();
        }

        VehicleLightsJson.Append(json, entity.Lights);
        json.Key("class").String(JsonName.Of(entity.Class)).Key("model").String(entity.Model);
        Append(json, entity.Pose)
            .Key("modelMin")
            .Exact(entity.ModelMin)
            .Key("modelMax")
            .Exact(entity.ModelMax)
            .Key("velocity")
            .Exact(entity.Velocity)
            .Key("hasRider")
            .Boolean(entity.HasRider);
        return entity.VehicleHandle is { } vehicle ? json.Key("vehicle").Integer(vehicle) : json;
    }

    private static JsonText Append(JsonText json, Pose pose) =>
        json.Key("position")
            .Exact(pose.Position)
            .Key("right")
            .Exact(pose.Axes.Right)
            .Key("forward")
            .Exact(pose.Axes.Forward)
            .Key("up")
            .Exact(pose.Axes.Up);
}
