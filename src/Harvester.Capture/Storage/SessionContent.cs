using System.Text;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Storage;

/// <summary>What a session directory already holds, as far as resuming the session needs it.</summary>
/// <param name="Header">The text of session.json; null if there is no such file.</param>
/// <param name="Frames">Frames with a label line.</param>
/// <param name="LastFrame">Number of the last frame; -1 if there is none.</param>
/// <param name="MaxObjectId">The greatest object id in use; 0 if there are no objects.</param>
/// <param name="Events">
/// Number of events at the beginning of their file that a game whose course is the same in every run gives again as they are: the others
/// were ended by the end of the harvest, or span frames after the last one.
/// </param>
/// <param name="MaxEventId">The greatest number of an event, ended or not; 0 if there are none.</param>
/// <param name="HasManifest">Whether there is a manifest; sessions of earlier versions have none.</param>
internal sealed record SessionContent(
    string? Header,
    int Frames,
    int LastFrame,
    int MaxObjectId,
    int Events,
    int MaxEventId,
    bool HasManifest
)
{
    /// <summary>Whether a manifest is kept; a session of an earlier version gets none of its later frames alone.</summary>
    public bool KeepsManifest => HasManifest || Frames == 0;

    public static SessionContent Nothing { get; } = new(null, 0, -1, 0, 0, 0, false);

    /// <summary>
    /// Reads a directory. An unfinished last line is cut off, so that the next one starts a line, and so are the lines of a last moment
    /// that lacks views.
    /// </summary>
    /// <param name="directory">The directory.</param>
    /// <param name="viewsPerMoment">Number of frames of a moment.</param>
    public static SessionContent Read(string directory, int viewsPerMoment = 1)
    {
        string header = Path.Combine(directory, SessionDirectory.Header);
        string labels = Path.Combine(directory, SessionDirectory.Labels);
        int frames = 0;
        int lastFrame = -1;
        int maxId = 0;
        int maxEvent = 0;
        int ended = 0;
        double lastTime = double.NegativeInfinity;
        if (File.Exists(labels))
        {
            CutLines(labels, 0);
            CutLines(labels, File.ReadLines(labels, Encoding.UTF8).Count() % viewsPerMoment);
            foreach (string line in File.ReadLines(labels, Encoding.UTF8))
            {
                (int? frame, int lineMaxId, int lineMaxEvent, double? time) = NumbersIn(line);
                lastTime = time ?? lastTime;
                lastFrame = frame ?? lastFrame + 1;
                frames++;
                maxId = Math.Max(maxId, lineMaxId);
                maxEvent = Math.Max(maxEvent, lineMaxEvent);
            }
        }

        string events = Path.Combine(directory, FramePaths.Events);
        if (File.Exists(events))
        {
            CutLines(events, 0);
            bool isFinal = true;
            foreach (string line in File.ReadLines(events, Encoding.UTF8))
            {
                (int id, int lineMaxId, double end) = NumbersInEvent(line);
                isFinal &= end <= lastTime;
                ended += isFinal ? 1 : 0;
                maxId = Math.Max(maxId, lineMaxId);
                maxEvent = Math.Max(maxEvent, id);
            }
        }

        return new SessionContent(
            File.Exists(header) ? File.ReadAllText(header, Encoding.UTF8) : null,
            frames,
            lastFrame,
            maxId,
            ended,
            maxEvent,
            File.Exists(Path.Combine(directory, Manifest.FileName))
        );
    }

    /// <summary>Whether a session with this header can be resumed under another one: both are equal up to the start of a run.</summary>
    public bool IsContinuedBy(string header) => Header is null || Settings(Header) == Settings(header);

    private static string Settings(string header)
    {
        int end = header.IndexOf(SessionJson.RunsBegin, StringComparison.Ordinal);
        return end < 0 ? header : header.Substring(0, end);
    }

    /// <summary>
    /// The number of a label line's frame and its greatest ids of objects and events; in a damaged line, those in the part before the
    /// damage.
    /// </summary>
    private static (int? Frame, int MaxId, int MaxEvent, double? Time) NumbersIn(string line)
    {
        int? frame = null;
        double? time = null;
        int maxId = 0;
        int maxEvent = 0;
        var json = new JsonReader(line);
        try
        {
            json.Object(field =>
            {
                if (field == "frame")
                {
                    frame = WholeNumber(json, int.MaxValue - 1, "a frame number out of range");
                }
                else if (field == "timeSeconds")
                {
                    time = json.Number();
                }
                else if (field == "events")
                {
                    ReadEach(json, "id", () => maxEvent = Math.Max(maxEvent, EventNumber(json)));
                }
                else
                {
                    ReadIf(json, field == "objects", () => ReadEach(json, "id", () => maxId = Math.Max(maxId, ObjectNumber(json))));
                }
            });
        }
        catch (FormatException)
        {
            // Frames that follow a damaged one are still worth recording; harvester validate reports the damage.
        }

        return (frame, maxId, maxEvent, time);
    }

    /// <summary>
    /// The number of an event, the greatest object id in its line, and its end, seconds, which is infinite if the harvest ended it; of a
    /// damaged line, what stands before the damage, and an infinite end.
    /// </summary>
    private static (int Id, int MaxId, double End) NumbersInEvent(string line)
    {
        int id = 0;
        int maxId = 0;
        double end = double.PositiveInfinity;
        bool isOver = false;
        var json = new JsonReader(line);
        try
        {
            json.Object(field =>
            {
                if (field == "id")
                {
                    id = EventNumber(json);
                }
                else if (field == "endSeconds")
                {
                    end = json.Number();
                }
                else if (field == "end")
                {
                    isOver = json.String() != JsonName.Of(EventEnd.SessionEnd);
                }
                else
                {
                    ReadIf(json, field == "participants", () => ReadEach(json, "object", () => maxId = Math.Max(maxId, ObjectOrEgo(json))));
                }
            });
        }
        catch (FormatException)
        {
            // As for a damaged label.
            isOver = false;
        }

        return (id, maxId, isOver ? end : double.PositiveInfinity);
    }

    private static int ObjectNumber(JsonReader json) => WholeNumber(json, ObjectRegistry.MaxId, "an object number out of range");

    private static int ObjectOrEgo(JsonReader json)
    {
        if (json.Next != 'n')
        {
            return ObjectNumber(json);
        }

        json.Null();
        return 0;
    }

    private static int EventNumber(JsonReader json) => WholeNumber(json, int.MaxValue - 1, "an event number out of range");

    /// <summary>Reads one field of each object of a list.</summary>
    private static void ReadEach(JsonReader json, string field, Action read) =>
        json.List(() => json.Object(name => ReadIf(json, name == field, read)));

    private static int WholeNumber(JsonReader json, int max, string wrong)
    {
        double number = json.Number();
        return number >= 0 && number <= max ? (int)number : throw json.Wrong(wrong);
    }

    private static void ReadIf(JsonReader json, bool isWanted, Action read)
    {
        if (isWanted)
        {
            read();
        }
        else
        {
            json.Skip();
        }
    }

    /// <summary>Cuts off the events that a game whose course is the same in every run gives again.</summary>
    public void CutEvents(string directory)
    {
        string events = Path.Combine(directory, FramePaths.Events);
        if (File.Exists(events))
        {
            CutLines(events, File.ReadLines(events, Encoding.UTF8).Count() - Events);
        }
    }

    /// <summary>Cuts off what follows the last line feed, and a number of lines before it.</summary>
    private static void CutLines(string file, int count)
    {
        using FileStream stream = AppendedFile.Open(file, FileAccess.ReadWrite);
        long end = stream.Length;
        for (int left = count; end > 0; end--)
        {
            stream.Position = end - 1;
            if (stream.ReadByte() == '\n' && left-- == 0)
            {
                break;
            }
        }

        if (end < stream.Length)
        {
            stream.SetLength(end);
        }
    }
}
