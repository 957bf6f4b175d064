using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes a frame's label as one line of JSON. Fields, units and ranges: docs/dataset-format.md.</summary>
public static class JsonLabelWriter
{
    /// <summary>The line of a frame, without the end of the line.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or too large to be written.</exception>
    public static string Line(FrameLabel frame)
    {
        if (frame is null)
        {
            throw new ArgumentNullException(nameof(frame));
        }

        var json = new JsonText();
        json.BeginObject().Key("frame").Integer(frame.Frame);
        if (frame.Moment is not null)
        {
            json.Key("moment").Integer(frame.Moment).Key("view").String(frame.View);
        }

        if (frame.Place is not null)
        {
            json.Key("place").Integer(frame.Place).Key("placeFrame").Integer(frame.PlaceFrame);
        }

        json.Key("gameFrame")
            .Integer(frame.GameFrame)
            .Key("timeSeconds")
            .Number(frame.TimeSeconds, LabelDecimals.Seconds)
            .Key("lagFrames")
            .Integer(frame.LagFrames)
            .Key("lagSeconds")
            .Number(frame.LagSeconds, LabelDecimals.Seconds)
            .Key("image")
            .String(frame.Image)
            .Key("mask")
            .String(frame.Mask);
        Append(json.Key("pixelMap"), frame.PixelMap);
        Append(json, FrameChannels.Maps, frame.Channels);
        Append(json.Key("rays"), frame.Rays);
        Append(json, FrameChannels.Others, frame.Channels);
        Append(json.Key("camera"), frame.Camera);
        Append(json.Key("ego"), frame.Ego);
        MotionJson.Append(json, frame.Motion);
        DriveJson.Append(json, frame.Drive);
        EventJson.AppendMarks(json, frame.Events);
        Append(json.Key("environment"), frame.Environment);
        json.Key("objects").BeginArray();
        foreach (ObjectLabel label in frame.Objects)
        {
            ObjectJson.Append(json, label);
        }

        json.EndArray().Key("ignoreRegions").BeginArray();
        foreach (IgnoreRegion region in frame.IgnoreRegions)
        {
            Append(json, region);
        }

        json.EndArray();
        if (frame.Lanes is { } lanes)
        {
            LanesJson.Append(json.Key("lanes"), lanes);
        }

        return json.EndObject().ToString();
    }

    /// <summary>The lanes as written in a label line.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite or too large to be written.</exception>
    public static string Lanes(LanesLabel lanes)
    {
        if (lanes is null)
        {
            throw new ArgumentNullException(nameof(lanes));
        }

        var json = new JsonText();
        LanesJson.Append(json, lanes);
        return json.ToString();
    }

    internal static void Append(JsonText json, CameraLabel camera)
    {
        json.BeginObject().Key("position").Vector(camera.Pose.Position, LabelDecimals.Metres);
        AxesJson.Append(json, camera.Pose.Axes);
        json.Key("verticalFovDegrees")
            .Number(camera.VerticalFovDegrees, LabelDecimals.CameraRatio)
            .Key("width")
            .Integer(camera.Width)
            .Key("height")
            .Integer(camera.Height)
            .Key("windowAspect")
            .Number(camera.WindowAspect, LabelDecimals.CameraRatio)
            .Key("nearClip")
            .Number(camera.NearClip, LabelDecimals.Metres)
            .Key("fx")
            .Number(camera.Fx, LabelDecimals.Intrinsics)
            .Key("fy")
            .Number(camera.Fy, LabelDecimals.Intrinsics)
            .Key("cx")
            .Number(camera.Cx, LabelDecimals.Intrinsics)
            .Key("cy")
            .Number(camera.Cy, LabelDecimals.Intrinsics)
            .Key("distortion")
            .BeginObject()
            .Key("focalScale")
            .Number(camera.Distortion.FocalScale, LabelDecimals.CameraRatio)
            .Key("k1")
            .Number(camera.Distortion.K1, LabelDecimals.CameraRatio)
            .Key("k2")
            .Number(camera.Distortion.K2, LabelDecimals.CameraRatio)
            .EndObject()
            .EndObject();
    }

    private static void Append(JsonText json, IReadOnlyList<FrameChannel> channels, ChannelLabels labels)
    {
        foreach (FrameChannel channel in channels)
        {
            if (channel.LabelIn(labels) is { } label)
            {
                channel.Append(json.Key(channel.Key), label);
            }
        }
    }

    private static void Append(JsonText json, PixelMapLabel? map)
    {
        if (map is null)
        {
            json.String(null);
            return;
        }

        json.BeginObject()
            .Key("resolutionPixels")
            .Integer(map.ResolutionPixels)
            .Key("interpolatedPixels")
            .Integer(map.InterpolatedPixels)
            .Key("raysCast")
            .Integer(map.RaysCast);
        if (map.Pictures is not null)
        {
            json.Key("pictures").Integer(map.Pictures).Key("undeterminedPixels").Integer(map.UndeterminedPixels);
        }

        json.EndObject();
    }

    private static void Append(JsonText json, RayCounts? rays)
    {
        if (rays is null)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("total")
            .Integer(rays.Total)
            .Key("map")
            .Integer(rays.Map)
            .Key("occlusion")
            .Integer(rays.Occlusion)
            .Key("faces")
            .Integer(rays.Faces)
            .Key("ignoreRegions")
            .Integer(rays.IgnoreRegions)
            .Key("lanes")
            .Integer(rays.Lanes)
            .Key("joints")
            .Integer(rays.Joints);
        foreach (string key in FrameChannels.All.Select(channel => channel.RaysKey).OfType<string>().Where(key => rays.Of(key) > 0))
        {
            json.Key(key).Integer(rays.Of(key));
        }

        json.EndObject();
    }

    private static void Append(JsonText json, EgoLabel ego)
    {
        json.BeginObject()
            .Key("position")
            .Vector(ego.Position, LabelDecimals.Metres)
            .Key("headingDegrees")
            .Number(RoundedHeading(ego.HeadingDegrees), LabelDecimals.Degrees);
        if (ego.Axes is { } axes)
        {
            AxesJson.Append(json, axes);
        }

        json.Key("heightAboveGroundMetres")
            .Number(ego.HeightAboveGroundMetres, LabelDecimals.Metres)
            .Key("velocity")
            .Vector(ego.Velocity, LabelDecimals.Speed)
            .Key("model")
            .String(ego.Model);
        if (ego.Motion is { } motion)
        {
            EgoMotionJson.Append(json, motion);
        }

        json.EndObject();
    }

    /// <summary>The heading in [0, 360) also after rounding: 359.99999 is written as 0.</summary>
    private static double RoundedHeading(double headingDegrees)
    {
        const double steps = 10_000;
        return Angles.WrapHeadingDegrees(Math.Floor((headingDegrees * steps) + 0.5) / steps);
    }

    private static void Append(JsonText json, EnvironmentState environment) =>
        json.BeginObject()
            .Key("weather")
            .String(environment.Weather)
            .Key("timeOfDay")
            .String(environment.TimeOfDay.ToString("hh\\:mm\\:ss", CultureInfo.InvariantCulture))
            .EndObject();

    private static void Append(JsonText json, IgnoreRegion region) =>
        json.BeginObject()
            .Key("reason")
            .String(JsonName.Of(region.Reason))
            .Key("class")
            .String(JsonName.Of(region.Class))
            .Key("box2d")
            .Box(region.Box2D, LabelDecimals.Pixels)
            .Key("distanceMetres")
            .Number(region.DistanceMetres, LabelDecimals.Metres)
            .EndObject();
}
