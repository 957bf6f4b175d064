using System.Globalization;
using System.Text.Json;
using Harvester.Exports.Formats.NuScenes;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>annotations.json: a line for each moment, and one for each split.</summary>
internal static class Occ3dAnnotations
{
    /// <summary>Writes the file.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="lines">The views of all frames, in their order.</param>
    /// <param name="scenes">The numbers of scenes.</param>
    public static void Write(TextWriter writer, IEnumerable<string> lines, Occ3dScenes scenes)
    {
        var splits = new SortedDictionary<string, List<string>>(StringComparer.Ordinal);
        writer.Write(Occ3dFiles.Begin);
        string between = "\n";
        int? previous = null;
        int? scene = null;
        Occ3dView[]? waiting = null;
        foreach (Occ3dView[] moment in Moments(lines.Select(Occ3dView.Read)))
        {
            int number = scenes.NumberOf(moment[0]);
            if (waiting is not null)
            {
                Flush(scene == number ? moment[0].Moment : null);
            }

            if (scene != number)
            {
                string name = NuScenesScene.NameOf(number);
                writer.Write(scene is null ? between : "\n},\n");
                writer.Write($"\"{name}\":{{");
                splits.TryAdd(moment[0].Split, []);
                splits[moment[0].Split].Add(name);
                (scene, previous, between) = (number, null, "\n");
            }

            waiting = moment;
        }

        if (waiting is not null)
        {
            Flush(null);
            writer.Write("\n}");
        }

        writer.Write("\n}");
        foreach ((string split, List<string> names) in splits)
        {
            writer.Write($",\n{Named(Occ3dFiles.FieldOf(split), json => WriteList(json, names))}");
        }

        writer.Write("\n}\n");

        void Flush(int? next)
        {
            writer.Write(between);
            writer.Write(Line(waiting, scene!.Value, previous, next));
            (previous, between) = (waiting[0].Moment, ",\n");
        }
    }

    private static string Line(Occ3dView[] views, int scene, int? previous, int? next)
    {
        int moment = views[0].Moment;
        string token = Occ3dScenes.TokenOf(scene, moment);
        return Named(
            token,
            json =>
            {
                json.WriteStartObject();
                json.WriteString("timestamp", views[0].Timestamp.ToString(CultureInfo.InvariantCulture));
                json.WriteStartObject("camera_sensor");
                foreach (Occ3dView view in views)
                {
                    json.WritePropertyName(NuScenesToken.Of("sample_data", scene, moment, view.Channel));
                    json.WriteRawValue(view.Camera);
                }

                json.WriteEndObject();
                json.WritePropertyName("ego_pose");
                json.WriteRawValue(views[0].Ego);
                json.WriteString("gt_path", Occ3dFiles.LabelsOf(NuScenesScene.NameOf(scene), token));
                json.WriteString("prev", previous is { } before ? Occ3dScenes.TokenOf(scene, before) : "");
                json.WriteString("next", next is { } after ? Occ3dScenes.TokenOf(scene, after) : "");
                json.WriteEndObject();
            }
        );
    }

    private static void WriteList(Utf8JsonWriter json, List<string> names)
    {
        json.WriteStartArray();
        names.ForEach(json.WriteStringValue);
        json.WriteEndArray();
    }

    /// <summary>A field of an object: its name, a colon and its value.</summary>
    private static string Named(string name, Action<Utf8JsonWriter> value) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WritePropertyName(name);
            value(json);
            json.WriteEndObject();
        })[1..^1];

    /// <summary>The views of each moment, which follow each other.</summary>
    private static IEnumerable<Occ3dView[]> Moments(IEnumerable<Occ3dView> views)
    {
        var moment = new List<Occ3dView>();
        foreach (Occ3dView view in views)
        {
            if (moment.Count > 0 && (moment[0].Recording != view.Recording || moment[0].Moment != view.Moment))
            {
                yield return [.. moment];
                moment.Clear();
            }

            moment.Add(view);
        }

        if (moment.Count > 0)
        {
            yield return [.. moment];
        }
    }
}
