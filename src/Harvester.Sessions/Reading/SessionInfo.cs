using System.Text.Json;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Rigs;

namespace Harvester.Sessions.Reading;

/// <summary>The content of session.json that readers need.</summary>
/// <param name="Game">The game of the harvest.</param>
/// <param name="Seed">The random seed; null for a game without one.</param>
/// <param name="Image">Size of all images, pixels; with a rig, that of the images of its first camera.</param>
/// <param name="CapturedFrames">Number of frames; null if the recording was cut off before it was written.</param>
/// <param name="Fault">The fault that ended the recording; null if there was none.</param>
public sealed record SessionInfo(string Game, long? Seed, ImageSize Image, int? CapturedFrames, string? Fault)
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "session.json";

    /// <summary>The rig of the harvest; null for a single camera.</summary>
    public Rig? Rig { get; init; }

    /// <summary>Frames, or moments of a rig, per second of the game's time; null if it is not recorded.</summary>
    public double? RateHz { get; init; }

    /// <summary>The noise of the inertial unit; null for an ideal one, or none.</summary>
    public ImuNoise? ImuNoise { get; init; }

    /// <summary>Whether the session has scenes; null if it is not recorded.</summary>
    public bool? KeepsScenes { get; init; }

    /// <summary>Whether the session was closed with a manifest; false in sessions of earlier versions.</summary>
    public bool HasManifest { get; init; }

    /// <summary>Number of discarded frames by reason; empty for a session that was cut off.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> Discards { get; init; } = [];

    /// <summary>
    /// Whether the freeze method was configured; false if it was chosen automatically, and in sessions of earlier versions.
    /// </summary>
    public bool IsFreezeGiven { get; init; }

    /// <summary>What spoils the pictures, one sentence; null if nothing was found.</summary>
    public string? PictureWarning { get; init; }

    /// <summary>Whether the game's display may be in the pictures, because hiding it changed nothing.</summary>
    public bool DoesDisplayStay { get; init; }

    /// <summary>What became of known colours in the pictures: kept, clipped or changed; null if it was not checked.</summary>
    public string? ColourState { get; init; }

    /// <summary>Whether its lanes come from a table of measured paint, where that shows them.</summary>
    public bool HasMeasuredPaint { get; init; }

    /// <summary>The supported version of the format.</summary>
    private const int KnownFormatVersion = 1;

    /// <summary>
    /// Checks that could not be made when the session was recorded, one line each; empty if all were made, or if the session was cut off.
    /// </summary>
    public IReadOnlyList<string> Unchecked { get; init; } = [];

    /// <summary>Reads the file.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message names the field, not the file.</exception>
    internal static SessionInfo Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            return Read(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InText(e), e);
        }
    }

    /// <summary>Reads the content of the file.</summary>
    /// <exception cref="DatasetFormatException">It is not what its format asks for; the message names the field, not the file.</exception>
    internal static SessionInfo Parse(byte[] content)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(content.AsMemory());
            return Read(new JsonFields(document.RootElement));
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InText(e), e);
        }
    }

    private static IEnumerable<string> UncheckedOf(JsonFields session)
    {
        // Markers seen in time prove both.
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
        return DeclaredSize.Problem(width, height) is { } problem
            ? throw new DatasetFormatException($"image has {problem}.")
            : new ImageSize(width, height);
    }

    private static Rig RigOf(JsonFields session)
    {
        try
        {
            return RigParser.Parse(session.RawText("rig"));
        }
        catch (FormatException e)
        {
            throw new DatasetFormatException($"rig: {e.Message}", e);
        }
    }

    private static SessionInfo Read(JsonFields session)
    {
        int version = session.Integer("formatVersion");
        if (version != KnownFormatVersion)
        {
            string remedy = version > KnownFormatVersion ? " Install a newer one." : string.Empty;
            throw new DatasetFormatException($"formatVersion is {version}; this program reads version {KnownFormatVersion}.{remedy}");
        }

        JsonFields image = session.Fields("image");
        return new SessionInfo(
            session.Text("game"),
            session.Has("seed") ? session.LongInteger("seed") : null,
            SizeOf(image),
            session.Has("counters") ? session.Fields("counters").Integer("captured") : null,
            session.OptionalText("fault")
        )
        {
            Rig = session.Has("rig") ? RigOf(session) : null,
            RateHz = session.Has("options") ? session.Fields("options").OptionalNumber("rateHz") : null,
            ImuNoise =
                session.Has("options") && session.Fields("options") is var options && options.Has("imuNoise")
                    ? NoiseOf(options.Fields("imuNoise"))
                    : null,
            KeepsScenes =
                session.Has("options") && session.Fields("options").Has("scenes") ? session.Fields("options").Boolean("scenes") : null,
            HasManifest = session.Has("manifest") && session.Boolean("manifest"),
            Discards =
                session.Has("counters") && session.Fields("counters").Has("discards")
                    ? DiscardsOf(session.Fields("counters").Fields("discards"))
                    : [],
            HasMeasuredPaint = session.Has("settings") && session.Fields("settings").Has("paint"),
            PictureWarning = session.Has("pictures") ? session.Fields("pictures").OptionalText("warning") : null,
            DoesDisplayStay =
                session.Has("start")
                && session.Fields("start") is var start
                && start.Has("display")
                && start.Fields("display").OptionalText("state") == "stays",
            ColourState =
                session.Has("start") && session.Fields("start") is var first && first.Has("colours")
                    ? first.Fields("colours").OptionalText("state")
                    : null,
            IsFreezeGiven = session.Has("options") && session.Fields("options").OptionalText("freezeBy") is not (null or "auto"),
            Unchecked = session.Has("counters") && session.Has("start") ? [.. UncheckedOf(session)] : [],
        };
    }

    private static ImuNoise NoiseOf(JsonFields noise) =>
        noise.Checked(() =>
            new ImuNoise
            {
                Gyroscope = noise.Number("gyroscope"),
                GyroscopeWalk = noise.Number("gyroscopeWalk"),
                Accelerometer = noise.Number("accelerometer"),
                AccelerometerWalk = noise.Number("accelerometerWalk"),
                Seed = noise.Integer("seed"),
            }
        );
}
