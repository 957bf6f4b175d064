using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Reading;

/// <summary>Reads a session on disk. Labels are streamed, so that sessions of any length can be read.</summary>
public sealed class SessionReader
{
    /// <summary>Name of the label file.</summary>
    public const string LabelsFile = "labels.jsonl";

    private readonly CancellationToken _cancellation;

    /// <summary>Opens the folder of a session.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="cancellation">Ends the reading of labels with an <see cref="OperationCanceledException"/>.</param>
    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="FileNotFoundException">The folder is not a session.</exception>
    public SessionReader(string folder, CancellationToken cancellation = default)
        : this(folder, cancellation, SessionInfo.FileName) { }

    private SessionReader(string folder, CancellationToken cancellation, params string[] marks)
    {
        _cancellation = cancellation;
        if (!Directory.Exists(folder))
        {
            throw new DirectoryNotFoundException(
                File.Exists(folder) ? $"'{folder}' is a file. Name the folder of a session." : $"Folder not found: '{folder}'."
            );
        }

        Folder = folder;
        if (!marks.Any(mark => File.Exists(PathOf(mark))))
        {
            throw new FileNotFoundException($"'{folder}' is not a session: it has no {string.Join(" and no ", marks)}.");
        }
    }

    /// <summary>The folder of the session, as given.</summary>
    public string Folder { get; }

    /// <summary>
    /// Whether the label file ends in a line without line feed, left by a harvest that was cut off. That line is not part of the session.
    /// </summary>
    public bool HasUnfinishedLine
    {
        get
        {
            string path = PathOf(LabelsFile);
            return File.Exists(path) && LineEnd.IsMissing(path);
        }
    }

    /// <summary>Opens the folder of a damaged session, which may lack session.json.</summary>
    /// <exception cref="DirectoryNotFoundException">The folder does not exist.</exception>
    /// <exception cref="FileNotFoundException">The folder has neither session.json nor labels.</exception>
    internal static SessionReader OpenDamaged(string folder) => new(folder, default, SessionInfo.FileName, LabelsFile);

    /// <summary>Whether the name of a file in a label stays within the session, with all links resolved.</summary>
    public bool IsWithin(string name) => InnerPath.IsWithin(Folder, name);

    /// <summary>The path of a file of the session.</summary>
    /// <param name="name">Path within the session, with forward slashes.</param>
    /// <exception cref="DatasetFormatException">The name points outside the session, or to a pipe or device.</exception>
    public string PathOf(string name) => InnerPath.Of(Folder, name);

    /// <summary>
    /// Whether a path belongs to the session: to one of its own files, to a file in its folders, or to a file that a label refers to.
    /// </summary>
    /// <param name="path">The path; links are resolved.</param>
    public bool Holds(string path)
    {
        string name = Path.GetRelativePath(InnerPath.Resolve(Folder), InnerPath.Resolve(path)).Replace('\\', '/');
        return name is SessionInfo.FileName or LabelsFile or Manifest.FileName or FramePaths.Events
            || FrameChannels.Folders.Contains(name.Split('/')[0], StringComparer.OrdinalIgnoreCase)
            || (InnerPath.IsWithin(Folder, name) && ReadLines().Any(line => line.Label?.Files.Contains(name) == true));
    }

    /// <summary>Reads session.json.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message names file and field.</exception>
    public SessionInfo ReadInfo()
    {
        try
        {
            return SessionInfo.Read(PathOf(SessionInfo.FileName));
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{SessionInfo.FileName}: {e.Message}", e);
        }
    }

    /// <summary>The labels, in the order of the file.</summary>
    /// <exception cref="DatasetFormatException">A line is invalid; the message names file, line and field.</exception>
    public IEnumerable<FrameLabel> ReadLabels() => ReadGoodLines().Select(line => line.Label!);

    /// <summary>The labels with their text, in the order of the file.</summary>
    /// <exception cref="DatasetFormatException">A line is invalid; the message names file, line and field.</exception>
    public IEnumerable<LabelLine> ReadGoodLines() =>
        ReadLines()
            .Select(line =>
                (line.Problem ?? IdProblem(line.Label!)) is { } problem
                    ? throw new DatasetFormatException($"{PathOf(LabelsFile)}, line {line.Number}: {problem}")
                    : line
            );

    /// <summary>The lines of the label file, including invalid ones; empty if no frame was written.</summary>
    public IEnumerable<LabelLine> ReadLines() => ReadLines(static (_, _) => []);

    /// <summary>The lines of the label file, including invalid ones, with what a check finds in the fields of the others.</summary>
    /// <param name="check">Looks at a label and its fields; several are checked at once.</param>
    internal IEnumerable<LabelLine> ReadLines(Func<FrameLabel, JsonFields, IReadOnlyList<string>> check) =>
        ReadAhead.Select(ReadTexts().Index(), line => ReadLine(line.Index + 1, line.Item, check));

    /// <summary>
    /// The lines of the events, with their numbers from 1; empty if the session has none. An unfinished last line is left out.
    /// </summary>
    public IEnumerable<EventLine> ReadEventLines()
    {
        string path = PathOf(FramePaths.Events);
        IEnumerable<string> lines =
            !File.Exists(path) ? []
            : LineEnd.IsMissing(path) ? InputFile.ReadLines(path).SkipLast(1)
            : InputFile.ReadLines(path);
        int number = 0;
        foreach (string line in lines)
        {
            _cancellation.ThrowIfCancellationRequested();
            yield return EventLine.Of(++number, line);
        }
    }

    /// <summary>The events, in the order in which they ended; empty if the session has none.</summary>
    /// <exception cref="DatasetFormatException">A line is invalid; the message names file, line and field.</exception>
    public IEnumerable<DrivingEvent> ReadEvents() =>
        ReadEventLines()
            .Select(line =>
                line.Event ?? throw new DatasetFormatException($"{PathOf(FramePaths.Events)}, line {line.Number}: {line.Problem}")
            );

    /// <summary>Number of lines of the label file, valid or not.</summary>
    public int CountLines() => ReadTexts().Count();

    /// <summary>The text of the lines, without an unfinished last one.</summary>
    internal IEnumerable<string> ReadTexts()
    {
        string path = PathOf(LabelsFile);
        IEnumerable<string> lines =
            !File.Exists(path) ? []
            : HasUnfinishedLine ? InputFile.ReadLines(path).SkipLast(1)
            : InputFile.ReadLines(path);
        foreach (string line in lines)
        {
            _cancellation.ThrowIfCancellationRequested();
            yield return line;
        }
    }

    /// <summary>Checks ids: objects are looked up by id, which is also their value in masks.</summary>
    internal static string? IdProblem(FrameLabel label)
    {
        var seen = new HashSet<int>();
        return label.Objects.FirstOrDefault(item => item.Id is < 1 or > ushort.MaxValue || !seen.Add(item.Id)) is not { } item ? null
            : seen.Contains(item.Id) ? $"two objects have the id {item.Id}."
            : $"an object has the id {item.Id}; ids are 1 to {ushort.MaxValue}.";
    }

    private static LabelLine ReadLine(int number, string line, Func<FrameLabel, JsonFields, IReadOnlyList<string>> check)
    {
        try
        {
            return FrameLabelParser.Parse(
                line,
                (label, fields) => new LabelLine(number, line, label, null) { Findings = check(label, fields) }
            );
        }
        catch (DatasetFormatException e)
        {
            return new LabelLine(number, line, null, e.Message);
        }
    }
}
