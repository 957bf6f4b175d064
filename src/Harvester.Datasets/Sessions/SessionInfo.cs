using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Harvester.Datasets.Files;
using Harvester.Datasets.Json;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Sessions;

/// <summary>What session.json says of a session as a whole, as far as readers need it.</summary>
/// <param name="Game">The game it was harvested from.</param>
/// <param name="Seed">What everything random of the game was drawn from; null in a game without a seed.</param>
/// <param name="Image">Size of all its images, pixels.</param>
/// <param name="CapturedFrames">How many frames it counted; null when the recording was cut off before it could count.</param>
/// <param name="Fault">Why the recording ended; null for a good end or none.</param>
public sealed record SessionInfo(string Game, long? Seed, ImageSize Image, int? CapturedFrames, string? Fault)
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "session.json";

    /// <summary>Whether it keeps the scenes that its labels were made from; null where it does not say.</summary>
    public bool? KeepsScenes { get; init; }

    /// <summary>Frames that were begun and thrown away, by reason; empty for a session that was cut off.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> Discards { get; init; } = [];

    /// <summary>
    /// Whether the game was frozen in a way that was given; false where both were tried, and in sessions of earlier versions.
    /// </summary>
    public bool IsFreezeGiven { get; init; }

    /// <summary>The version of the format that this reader knows.</summary>
    private const int KnownFormatVersion = 1;

    /// <summary>
    /// What was not made sure of when the session was recorded, a line each; empty when all was, and for one that was cut off.
    /// </summary>
    public IReadOnlyList<string> Unchecked { get; init; } = [];

    /// <summary>Reads the file.</summary>
    /// <exception cref="DatasetFormatException">It is not what its format asks for; the message names the field, not the file.</exception>
    internal static SessionInfo Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            return Read(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"not JSON, line {e.LineNumber + 1}.", e);
        }
    }

    private static IEnumerable<string> UncheckedOf(JsonFields session)
    {
        // Markers that are seen in time show both.
        if (session.Fields("start").Has("cameraErrorPixels"))
        {
            yield break;
        }

        yield return "The camera model was not checked against markers; check that the boxes align with the objects.";
        if (!session.Has("pictureLag"))
        {
            yield return "Picture lag could not be measured; check that the boxes align with moving objects.";
        }
    }

    private static KeyValuePair<string, int>[] DiscardsOf(JsonFields discards) =>
        [.. discards.Names.Select(reason => KeyValuePair.Create(reason, discards.Integer(reason)))];

    private static ImageSize SizeOf(JsonFields image)
    {
        int width = image.Integer("width");
        int height = image.Integer("height");
        return DeclaredSize.Problem(width, height) is { } problem ? throw new DatasetFormatException($"image has {problem}.")
            : new ImageSize(width, height);
    }

    private static SessionInfo Read(JsonFields session)
    {
        int version = session.Integer("formatVersion");
        if (version != KnownFormatVersion)
        {
            throw new DatasetFormatException($"formatVersion is {version}; this program supports only version {KnownFormatVersion}.");
        }

        JsonFields image = session.Fields("image");
        return new SessionInfo(
            session.Text("game"),
            session.Has("seed") ? session.LongInteger("seed") : null,
            SizeOf(image),
            session.Has("counters") ? session.Fields("counters").Integer("captured") : null,
            session.OptionalText("fault"))
        {
            KeepsScenes = session.Has("options") && session.Fields("options").Has("scenes") ? session.Fields("options").Boolean("scenes")
                : null,
            Discards = session.Has("counters") && session.Fields("counters").Has("discards")
                ? DiscardsOf(session.Fields("counters").Fields("discards")) : [],
            IsFreezeGiven = session.Has("options") && session.Fields("options").OptionalText("freezeBy") is not (null or "auto"),
            Unchecked = session.Has("counters") && session.Has("start") ? [.. UncheckedOf(session)] : [],
        };
    }
}
