using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Events;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Storage;

/// <summary>Writes session.json. Fields, units and ranges: docs/dataset-format.md. No value comes from the system clock.</summary>
internal static class SessionJson
{
    /// <summary>The version of the format. It is raised when a reader of older sessions would misread a newer one.</summary>
    public const int FormatVersion = 1;

    /// <summary>Marks the start of the part that differs between the runs of one session.</summary>
    public const string RunsBegin = "\n  \"start\": ";

    public static string Text(SessionRecord record)
    {
        HarvestOptions options = record.Start.Options;
        JsonText json = Begun(record.Origin, options);
        json.Key("start")
            .BeginObject()
            .Key("gameFrame")
            .Integer(record.Start.GameFrame)
            .Key("timeSeconds")
            .Number(record.Start.TimeSeconds, LabelDecimals.Seconds)
            .Key("recordedUtc")
            .String(record.Origin.RecordedUtc)
            .Key("cameraErrorPixels")
            .Number(record.Start.CameraErrorPixels, LabelDecimals.Pixels);
        if (record.Start.Freezing is { } freezing)
        {
            Append(json.Key("freezing"), freezing);
        }

        if (record.Start.Display is { } display)
        {
            json.Key("display")
                .BeginObject()
                .Key("state")
                .String(JsonName.Of(display.State))
                .Key("region")
                .String(display.Region)
                .EndObject();
        }

        if (record.Start.Colours is { } colours)
        {
            json.Key("colours")
                .BeginObject()
                .Key("state")
                .String(JsonName.Of(colours.State))
                .Key("grey192")
                .Number(colours.Light, 1)
                .Key("grey128")
                .Number(colours.Middle, 1)
                .EndObject();
        }

        json.EndObject();
        JsonLabelWriter.Append(json.Key("camera"), CameraLabel.Of(options.CameraOf(record.Start.Camera)));
        AppendEnd(json, record);
        return json.EndObject() + "\n";
    }

    /// <summary>What all runs of one session begin with, as far as <see cref="RunsBegin"/>.</summary>
    public static string Settings(SessionOrigin origin, HarvestOptions options) => $"{Begun(origin, options)},";

    private static JsonText Begun(SessionOrigin origin, HarvestOptions options)
    {
        var json = new JsonText(indented: true);
        json.BeginObject()
            .Key("formatVersion")
            .Integer(FormatVersion)
            .Key("tool")
            .String(origin.Tool)
            .Key("captureVersion")
            .String(typeof(SessionJson).Assembly.GetName().Version!.ToString(3))
            .Key("game")
            .String(origin.Game)
            .Key("seed")
            .Integer(origin.Seed)
            .Key("settings")
            .BeginObject();
        foreach (KeyValuePair<string, string> setting in origin.Settings)
        {
            json.Key(setting.Key).String(setting.Value);
        }

        json.EndObject()
            .Key("image")
            .BeginObject()
            .Key("width")
            .Integer(options.Image.Width)
            .Key("height")
            .Integer(options.Image.Height)
            .Key("format")
            .String(JsonName.Of(options.Format))
            .Key("quality")
            .Integer(options.Format == ImageFormat.Jpeg ? options.JpegQuality : null)
            .EndObject();
        if (options.Rig is { } rig)
        {
            RigJson.Append(json.Key("rig"), rig);
        }

        AppendBoxes(json.Key("boxes"));
        Append(json.Key("options"), options);
        json.Key("classes").BeginArray();
        foreach (ObjectClass each in ClassesOf(options))
        {
            json.String(JsonName.Of(each));
        }

        json.EndArray();
        AppendTruth(json, origin.Truth);
        return json;
    }

    private static IEnumerable<ObjectClass> ClassesOf(HarvestOptions options) =>
        typeof(ObjectClass).GetEnumValues().Cast<ObjectClass>().Where(each => options.Classes?.Contains(each) ?? true);

    private static void Append(JsonText json, HarvestOptions options)
    {
        json.BeginObject()
            .Key("rateHz")
            .Number(options.RateHz, LabelDecimals.Seconds)
            .Key("rangeMetres")
            .Number(options.RangeMetres, LabelDecimals.Metres)
            .Key("ignoreRangeMetres")
            .Number(options.IgnoreRangeMetres, LabelDecimals.Metres)
            .Key("freeze")
            .Boolean(options.Freeze)
            .Key("freezeBy")
            .String(options.FreezeBy is { } method ? JsonName.Of(method) : "auto")
            .Key("masks")
            .Boolean(options.Masks);
        if (options is { Masks: true, MaskMethod: not MaskMethod.Rays })
        {
            json.Key("maskMethod").String(JsonName.Of(options.MaskMethod));
        }

        foreach (string key in FrameChannels.All.Select(static channel => channel.Key).Where(options.Channels.Contains))
        {
            json.Key(key).Boolean(true);
        }

        if (options.Channels.Contains(FrameChannels.BirdsEye.Key))
        {
            json.Key("birdsEyeGrid")
                .BeginObject()
                .Key("sideMetres")
                .Number(options.BirdsEye.SideMetres, LabelDecimals.Metres)
                .Key("cellMetres")
                .Number(options.BirdsEye.CellMetres, LabelDecimals.Metres)
                .EndObject();
        }

        if (options.Motion)
        {
            json.Key("motion").Boolean(true);
        }

        if (options.ImuNoise is { } noise && options.Channels.Contains(FrameChannels.Imu.Key))
        {
            Append(json.Key("imuNoise"), noise);
        }

        if (options.GnssNoise is { } errors && options.Channels.Contains(FrameChannels.Gnss.Key))
        {
            Append(json.Key("gnssNoise"), errors);
        }

        if (options.Events is { } events)
        {
            json.Key("events")
                .BeginObject()
                .Key("rateHz")
                .Number(events.RateHz, LabelDecimals.Seconds)
                .Key("rangeMetres")
                .Number(events.RangeMetres, LabelDecimals.Metres);
            if (events.KeepAroundSeconds is { } around)
            {
                json.Key("keepAroundSeconds").Number(around, LabelDecimals.Seconds).Key("keepKinds").BeginArray();
                foreach (EventKind kind in events.KeepKinds)
                {
                    json.String(JsonName.Of(kind));
                }

                json.EndArray();
            }

            json.EndObject();
        }

        json.Key("semantics")
            .String(options.Semantics is { } semantics ? JsonName.Of(semantics) : null)
            .Key("scenes")
            .Boolean(options.Scenes)
            .Key("rayBudget")
            .Integer(options.RayBudget)
            .Key("rayReachMetres")
            .Number(options.RayReachMetres, LabelDecimals.Metres)
            .Key("minBoxAreaPixels")
            .Number(options.MinBoxAreaPixels, LabelDecimals.Pixels)
            .Key("minBoxSidePixels")
            .Number(options.MinBoxSidePixels, LabelDecimals.Pixels)
            .Key("maxOccludedFraction")
            .Number(options.MaxOccludedFraction, LabelDecimals.Fraction)
            .Key("occlusionSamples")
            .Integer(options.OcclusionSamples)
            .Key("maxPictureLagTicks")
            .Integer(options.MaxPictureLagTicks)
            .Key("maxSettleTicks")
            .Integer(options.MaxSettleTicks)
            .Key("stillToleranceMetres")
            .Number(options.StillToleranceMetres, LabelDecimals.Seconds);
        if (options.Pairs.IsAny)
        {
            Append(json.Key("pairs"), options.Pairs);
        }

        json.EndObject();
    }

    private static void Append(JsonText json, ImuNoise noise) =>
        json.BeginObject()
            .Key("gyroscope")
            .Number(noise.Gyroscope, ImuNoise.Decimals)
            .Key("gyroscopeWalk")
            .Number(noise.GyroscopeWalk, ImuNoise.Decimals)
            .Key("accelerometer")
            .Number(noise.Accelerometer, ImuNoise.Decimals)
            .Key("accelerometerWalk")
            .Number(noise.AccelerometerWalk, ImuNoise.Decimals)
            .Key("seed")
            .Integer(noise.Seed)
            .EndObject();

    private static void Append(JsonText json, GnssNoise noise) =>
        json.BeginObject()
            .Key("horizontal")
            .Number(noise.Horizontal, GnssNoise.Decimals)
            .Key("vertical")
            .Number(noise.Vertical, GnssNoise.Decimals)
            .Key("horizontalWalk")
            .Number(noise.HorizontalWalk, GnssNoise.Decimals)
            .Key("verticalWalk")
            .Number(noise.VerticalWalk, GnssNoise.Decimals)
            .Key("velocity")
            .Number(noise.Velocity, GnssNoise.Decimals)
            .Key("seed")
            .Integer(noise.Seed)
            .EndObject();

    private static void Append(JsonText json, PairOptions pairs)
    {
        json.BeginObject().Key("weathers").BeginArray();
        foreach (string weather in pairs.Weathers)
        {
            json.String(weather);
        }

        json.EndArray().Key("hours").BeginArray();
        foreach (int hour in pairs.Hours)
        {
            json.Integer(hour);
        }

        json.EndArray().Key("without").BeginArray();
        foreach (HiddenChoice choice in pairs.Without)
        {
            json.String(choice.Name);
        }

        json.EndArray().Key("maxTicks").Integer(pairs.MaxTicks).EndObject();
    }

    private static void AppendTruth(JsonText json, IReadOnlyList<KeyValuePair<string, LabelTruth>> truth)
    {
        if (truth.Count == 0)
        {
            return;
        }

        json.Key("truth").BeginObject();
        foreach (KeyValuePair<string, LabelTruth> label in truth)
        {
            json.Key(label.Key).String(JsonName.Of(label.Value));
        }

        json.EndObject();
    }

    private static void Append(JsonText json, FreezeReport freezing)
    {
        json.BeginObject().Key("used").String(JsonName.Of(freezing.Method)).Key("tried").BeginArray();
        foreach (FreezeFinding finding in freezing.Findings)
        {
            json.BeginObject()
                .Key("method")
                .String(JsonName.Of(finding.Method))
                .Key("sawMovement")
                .Boolean(finding.SawMovement)
                .Key("settleTicks")
                .Integer(finding.SettleTicks)
                .Key("holdsEnvironment")
                .Boolean(finding.HoldsEnvironment)
                .Key("movesCamera")
                .Boolean(finding.MovesCamera)
                .Key("pictureChange")
                .Number(finding.PictureChange, LabelDecimals.Fraction)
                .EndObject();
        }

        json.EndArray().EndObject();
    }

    /// <summary>The field of an object that holds each box, by the names of harvester export --boxes.</summary>
    private static void AppendBoxes(JsonText json) =>
        json.BeginObject()
            .Key("visible")
            .String("box2dVisible")
            .Key("amodal")
            .String("box2dAmodal")
            .Key("cuboid")
            .String("box2d")
            .EndObject();

    private static void AppendEnd(JsonText json, SessionRecord record)
    {
        if (record.End is not { } end)
        {
            json.Key("state").String("recording");
            return;
        }

        json.Key("state").String(end.Fault is null ? "complete" : "faulted").Key("fault").String(PathlessText.Of(end.Fault));
        if (record.HasManifest)
        {
            json.Key("manifest").Boolean(true);
        }

        json.Key("end")
            .BeginObject()
            .Key("gameFrame")
            .Integer(end.GameFrame)
            .Key("timeSeconds")
            .Number(end.TimeSeconds, LabelDecimals.Seconds)
            .EndObject()
            .Key("counters")
            .BeginObject()
            .Key("captured")
            .Integer(record.FramesWritten)
            .Key("discarded")
            .Integer(end.Discards.Sum(static discard => discard.Value))
            .Key("discards")
            .BeginObject();
        foreach (KeyValuePair<string, int> discard in end.Discards)
        {
            json.Key(discard.Key).Integer(discard.Value);
        }

        json.EndObject().Key("settleTicks").BeginObject();
        foreach (KeyValuePair<int, int> settle in end.SettleTicks)
        {
            json.Key(settle.Key.ToString(CultureInfo.InvariantCulture)).Integer(settle.Value);
        }

        json.EndObject().EndObject();
        if (end.Lag is { } lag)
        {
            json.Key("pictureLag")
                .BeginObject()
                .Key("cameraTicks")
                .Integer(lag.CameraTicks)
                .Key("entityTicks")
                .Integer(lag.EntityTicks)
                .EndObject();
        }

        if (end.MaskComparison is not null || end.MaskWarning is not null)
        {
            AppendMasks(json.Key("masks"), end);
        }

        if (end.PictureWarning is not null)
        {
            json.Key("pictures").BeginObject().Key("warning").String(end.PictureWarning).EndObject();
        }

        if (end.Reading is { } reading)
        {
            json.Key("reading")
                .BeginObject()
                .Key("vehicles")
                .String(JsonName.Of(reading.Vehicles))
                .Key("peds")
                .String(JsonName.Of(reading.Peds))
                .Key("props")
                .String(JsonName.Of(reading.Props))
                .Key("distortedEntities")
                .Integer(reading.DistortedEntities)
                .EndObject();
        }
    }

    private static void AppendMasks(JsonText json, SessionEnd end)
    {
        json.BeginObject().Key("warning").String(end.MaskWarning);
        if (end.MaskComparison is { } comparison)
        {
            json.Key("objectPixels")
                .Integer(comparison.ObjectPixels)
                .Key("differentPixels")
                .Integer(comparison.DifferentPixels)
                .Key("agreement")
                .BeginArray();
            foreach (MaskAgreement each in comparison.Classes)
            {
                json.BeginObject()
                    .Key("class")
                    .String(JsonName.Of(each.Class))
                    .Key("objects")
                    .Integer(each.Objects)
                    .Key("meanIou")
                    .Number(each.MeanIou, LabelDecimals.Fraction)
                    .EndObject();
            }

            json.EndArray();
        }

        json.EndObject();
    }
}
