using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Rigs;

/// <summary>Writes a rig as <see cref="RigParser"/> reads it, with every value in full.</summary>
internal static class RigJson
{
    /// <summary>Decimals of angles that are computed from axes.</summary>
    private const int AngleDecimals = 9;

    public static void Append(JsonText json, Rig rig)
    {
        json.BeginObject().Key("name").String(rig.Name).Key("origin").Exact(rig.Origin).Key("cameras").BeginArray();
        foreach (RigCamera camera in rig.Cameras)
        {
            json.BeginObject().Key("name").String(camera.Name);
            Append(json, camera.Mount)
                .Key("verticalFovDegrees")
                .Exact(camera.VerticalFovDegrees)
                .Key("width")
                .Integer(camera.Image.Width)
                .Key("height")
                .Integer(camera.Image.Height);
            if (camera.Lens != Lens.Ideal)
            {
                json.Key("lens")
                    .BeginObject()
                    .Key("focalScale")
                    .Exact(camera.Lens.FocalScale)
                    .Key("centreOffsetX")
                    .Exact(camera.Lens.CentreOffsetX)
                    .Key("centreOffsetY")
                    .Exact(camera.Lens.CentreOffsetY)
                    .Key("k1")
                    .Exact(camera.Lens.K1)
                    .Key("k2")
                    .Exact(camera.Lens.K2)
                    .EndObject();
            }

            json.EndObject();
        }

        json.EndArray().Key("lidars").BeginArray();
        foreach (RigLidar lidar in rig.Lidars)
        {
            Append(json, lidar);
        }

        json.EndArray();
        if (rig.Radars.Count > 0)
        {
            json.Key("radars").BeginArray();
            foreach (RigRadar radar in rig.Radars)
            {
                Append(json, radar);
            }

            json.EndArray();
        }

        json.EndObject();
    }

    private static void Append(JsonText json, RigRadar radar)
    {
        json.BeginObject().Key("name").String(radar.Name);
        Append(json, radar.Mount)
            .Key("azimuthDegrees")
            .Exact(radar.AzimuthDegrees)
            .Key("elevationDegrees")
            .Exact(radar.ElevationDegrees)
            .Key("rangeMetres")
            .Exact(radar.RangeMetres)
            .Key("azimuthStepDegrees")
            .Exact(radar.AzimuthStepDegrees)
            .Key("rangeStepMetres")
            .Exact(radar.RangeStepMetres)
            .Key("rangeNoiseMetres")
            .Exact(radar.RangeNoiseMetres)
            .Key("azimuthNoiseDegrees")
            .Exact(radar.AzimuthNoiseDegrees)
            .Key("velocityNoise")
            .Exact(radar.VelocityNoise)
            .Key("ghostFraction")
            .Exact(radar.GhostFraction)
            .Key("clutter")
            .Exact(radar.Clutter)
            .Key("maxDetections")
            .Integer(radar.MaxDetections)
            .EndObject();
    }

    private static void Append(JsonText json, RigLidar lidar)
    {
        json.BeginObject().Key("name").String(lidar.Name);
        if (lidar.Model is { } model)
        {
            json.Key("model").String(model);
        }

        Append(json, lidar.Mount).Key("beamsDegrees").BeginArray();
        foreach (double beam in lidar.BeamsDegrees)
        {
            json.Exact(beam);
        }

        json.EndArray()
            .Key("columns")
            .Integer(lidar.Columns)
            .Key("rateHz")
            .Exact(lidar.RateHz)
            .Key("minRangeMetres")
            .Exact(lidar.MinRangeMetres)
            .Key("rangeMetres")
            .Exact(lidar.RangeMetres)
            .Key("rangeNoiseMetres")
            .Exact(lidar.RangeNoiseMetres)
            .Key("dropOutFraction")
            .Exact(lidar.DropOutFraction);
        if (lidar.RayFraction < 1)
        {
            json.Key("rayFraction").Exact(lidar.RayFraction);
        }

        if (lidar.MotionDistortion)
        {
            json.Key("motionDistortion").Boolean(true);
        }

        json.EndObject();
    }

    private static JsonText Append(JsonText json, Pose mount)
    {
        EulerAngles angles = mount.Axes.ToEuler();
        return json.Key("position")
            .Exact(mount.Position)
            .Key("yawDegrees")
            .Number(angles.YawDegrees, AngleDecimals)
            .Key("pitchDegrees")
            .Number(angles.PitchDegrees, AngleDecimals)
            .Key("rollDegrees")
            .Number(angles.RollDegrees, AngleDecimals);
    }
}
