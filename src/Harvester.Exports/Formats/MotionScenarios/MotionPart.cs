using System.Text.Json;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>What a frame adds to scenarios as a temporary file, which is read again when all frames are done.</summary>
internal static class MotionPart
{
    /// <summary>Decimals of seconds, metres and metres per second; of radians one more digit than a car's corner shows.</summary>
    private const int Seconds = 6;
    private const int Metres = 5;
    private const int Radians = 7;

    /// <summary>Writes the file of a moment.</summary>
    public static void Write(Stream stream, MotionMoment moment)
    {
        using var json = new Utf8JsonWriter(stream);
        json.WriteStartObject();
        json.Number("time", moment.Seconds, Seconds);
        json.WriteStartArray("actors");
        foreach (MotionActor actor in moment.Actors)
        {
            WriteActor(json, actor);
        }

        json.WriteEndArray();
        json.WriteStartObject("lights");
        foreach ((string lane, LogLight light) in moment.Lights)
        {
            json.WriteNumber(lane, (int)light);
        }

        json.WriteEndObject();
        json.WriteStartArray("map");
        foreach (NamedFeature feature in moment.Features)
        {
            WriteFeature(json, feature);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Reads a file.</summary>
    public static MotionMoment Parse(byte[] text)
    {
        using JsonDocument document = JsonDocument.Parse(text);
        var moment = new JsonFields(document.RootElement);
        JsonFields lights = moment.Fields("lights");
        return new MotionMoment(
            moment.Number("time"),
            [.. moment.List("actors").Select(ActorOf)],
            lights.Names.ToDictionary(lane => lane, lane => (LogLight)lights.Integer(lane), StringComparer.Ordinal),
            [.. moment.List("map").Select(FeatureOf)]
        );
    }

    private static void WriteActor(Utf8JsonWriter json, MotionActor actor)
    {
        json.WriteStartObject();
        json.WriteString("key", actor.Key);
        if (actor.Id is { } id)
        {
            json.WriteNumber("id", id);
        }

        json.WriteNumber("kind", (int)actor.Kind);
        LogState state = actor.State;
        json.Numbers("centre", [state.Centre.X, state.Centre.Y, state.Centre.Z], Metres);
        json.Numbers("size", [state.Length, state.Width, state.Height], Metres);
        json.Number("heading", state.Heading, Radians);
        json.Numbers("velocity", [state.Velocity.X, state.Velocity.Y], Metres);
        json.WriteEndObject();
    }

    private static MotionActor ActorOf(JsonFields actor)
    {
        double[] size = actor.Numbers("size", 3);
        double[] velocity = actor.Numbers("velocity", 2);
        return new MotionActor(
            actor.Text("key"),
            actor.Has("id") ? actor.Integer("id") : null,
            (TrafficLogKind)actor.Integer("kind"),
            new LogState(actor.Vector("centre"), size[0], size[1], size[2], actor.Number("heading"), new Vector2D(velocity[0], velocity[1]))
        );
    }

    private static void WriteFeature(Utf8JsonWriter json, NamedFeature feature)
    {
        json.WriteStartObject();
        json.WriteString("name", feature.Name);
        json.WriteNumber("kind", (int)feature.Kind);
        json.WriteNumber("type", feature.Type);
        json.WriteBoolean("way", feature.IsWay);
        json.WriteStartArray("points");
        foreach (Vector3D point in feature.Points)
        {
            json.Values([point.X, point.Y, point.Z], Metres);
        }

        json.WriteEndArray();
        foreach ((string name, IReadOnlyList<string> names) in ListsOf(feature))
        {
            if (names.Count > 0)
            {
                json.WriteStartArray(name);
                foreach (string other in names)
                {
                    json.WriteStringValue(other);
                }

                json.WriteEndArray();
            }
        }

        json.WriteEndObject();
    }

    private static IEnumerable<(string Name, IReadOnlyList<string> Names)> ListsOf(NamedFeature feature) =>
        [
            ("entries", feature.Entries),
            ("exits", feature.Exits),
            ("left", feature.Left),
            ("right", feature.Right),
            ("leftLines", feature.LeftLines),
            ("rightLines", feature.RightLines),
            ("lanes", feature.Lanes),
        ];

    private static NamedFeature FeatureOf(JsonFields feature)
    {
        IReadOnlyList<string> Names(string name) => feature.Has(name) ? feature.Texts(name) : [];
        return new NamedFeature(
            feature.Text("name"),
            (LogFeatureKind)feature.Integer("kind"),
            feature.Integer("type"),
            feature.Vectors("points")
        )
        {
            IsWay = feature.Boolean("way"),
            Entries = Names("entries"),
            Exits = Names("exits"),
            Left = Names("left"),
            Right = Names("right"),
            LeftLines = Names("leftLines"),
            RightLines = Names("rightLines"),
            Lanes = Names("lanes"),
        };
    }
}
