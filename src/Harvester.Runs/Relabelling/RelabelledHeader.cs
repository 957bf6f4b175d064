using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Runs.Relabelling;

/// <summary>The session.json of a relabelled session: the recorded one with the changed options and the tool that relabelled it.</summary>
public sealed class RelabelledHeader(RecordedSession recorded, RelabelOptions changes, HarvestOptions options)
{
    /// <summary>The text of the file.</summary>
    public string Text(int frames)
    {
        SessionHeader header = SessionHeader.Read(recorded.Session);
        JsonObject json = header.Json;
        JsonObject settings = json["settings"]!.AsObject();
        header.Shard = null;
        Set(settings, "lookAhead", changes.LookAhead?.ToString());
        Set(settings, "laneWidth", changes.LaneWidthMetres?.ToString(CultureInfo.InvariantCulture));
        Set(settings, "narrowLaneWidth", changes.NarrowLaneWidthMetres?.ToString(CultureInfo.InvariantCulture));
        Set(settings, "roads", changes.RoadsName);
        Set(settings, "paint", changes.PaintName);
        Set(settings, "spaces", changes.FacesName);
        Set(settings, "relabelledBy", $"harvester {typeof(RelabelledHeader).Assembly.GetName().Version!.ToString(3)}");
        header.Shard = changes.Shard.Count > 1 ? changes.Shard : null;
        JsonObject asked = json["options"]!.AsObject();
        Set(asked, "rangeMetres", changes.RangeMetres, 4);
        Set(asked, "minBoxAreaPixels", changes.MinBoxAreaPixels, 3);
        Set(asked, "minBoxSidePixels", changes.MinBoxSidePixels, 3);
        Set(asked, "maxOccludedFraction", changes.MaxOccludedFraction, 4);
        asked["masks"] = options.Masks;
        asked["semantics"] = options.Semantics is { } semantics ? JsonName.Of(semantics) : null;
        foreach (string key in recorded.Options.Channels.Keys.Except(options.Channels.Keys))
        {
            asked.Remove(key);
        }

        asked["scenes"] = false;
        json["classes"] = new JsonArray([
            .. Enum.GetValues<ObjectClass>().Where(kind => options.Classes!.Contains(kind)).Select(kind => (JsonNode)JsonName.Of(kind)!),
        ]);
        if (changes.Lens is { } lens)
        {
            SetLens(json["camera"]!.AsObject(), lens);
        }

        header.SetManifest();
        if (json["counters"] is JsonObject counters)
        {
            counters["captured"] = frames;
        }

        return header.ToString();
    }

    private static void SetLens(JsonObject camera, Lens lens)
    {
        const int intrinsicsDecimals = 6;
        const int lensDecimals = 9;
        var fields = new JsonFields(camera.Deserialize<JsonElement>());
        CameraIntrinsics made = fields.Checked(() =>
            new CameraIntrinsics(
                fields.Number("verticalFovDegrees"),
                new ImageSize(fields.Integer("width"), fields.Integer("height")),
                fields.Number("windowAspect"),
                fields.Number("nearClip"),
                lens
            )
        );
        Set(camera, "fx", made.Fx, intrinsicsDecimals);
        Set(camera, "fy", made.Fy, intrinsicsDecimals);
        Set(camera, "cx", made.Cx, intrinsicsDecimals);
        Set(camera, "cy", made.Cy, intrinsicsDecimals);
        JsonObject distortion = camera["distortion"]!.AsObject();
        Set(distortion, "focalScale", lens.FocalScale, lensDecimals);
        Set(distortion, "k1", lens.K1, lensDecimals);
        Set(distortion, "k2", lens.K2, lensDecimals);
    }

    private static void Set(JsonObject target, string name, string? value)
    {
        if (value is not null)
        {
            target[name] = value;
        }
    }

    private static void Set(JsonObject target, string name, double? value, int decimals)
    {
        if (value is { } number)
        {
            target[name] = JsonNode.Parse(InvariantNumber.Format(number, decimals));
        }
    }
}
