using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Sessions;

/// <summary>Reads a session as it lies on disk; labels are streamed, so that a session of any length can be read.</summary>
public sealed class SessionReader
{
    /// <summary>Name of the file of labels.</summary>
    public const string LabelsFile = "labels.jsonl";

    /// <summary>Takes a session's folder.</summary>
    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="FileNotFoundException">The folder is not a session.</exception>
    public SessionReader(string folder)
    {
        if (!Directory.Exists(folder))
        {
            throw new DirectoryNotFoundException(
                File.Exists(folder) ? $"'{folder}' is a file. Name the folder of a session." : $"Folder not found: '{folder}'.");
        }

        Folder = folder;
        if (!File.Exists(PathOf(SessionInfo.FileName)))
        {
            throw new FileNotFoundException($"'{folder}' is not a session: it has no {SessionInfo.FileName}.");
        }
    }

    /// <summary>The session's folder, as it was given.</summary>
    public string Folder { get; }

    /// <summary>
    /// Whether the labels end in a line without a line feed, a leftover of a harvest that was cut off; it is no part of the session.
    /// </summary>
    public bool HasUnfinishedLine
    {
        get
        {
            string path = PathOf(LabelsFile);
            if (!File.Exists(path))
            {
                return false;
            }

            using FileStream file = InputFile.OpenRead(path);
            if (file.Length == 0)
            {
                return false;
            }

            file.Seek(-1, SeekOrigin.End);
            return file.ReadByte() != '\n';
        }
    }

    /// <summary>Whether a name that a label gives for a file stays within the session, with all links resolved.</summary>
    public bool IsWithin(string name) => InnerPath.IsWithin(Folder, name);

    /// <summary>Where a file of the session lies.</summary>
    /// <param name="name">Its path within the session, with forward slashes.</param>
    /// <exception cref="DatasetFormatException">The name leads out of the session, or to a pipe or a device.</exception>
    public string PathOf(string name) => InnerPath.Of(Folder, name);

    /// <summary>
    /// Whether a path is that of a file of the session: one with a name of its own, one in its folders, or one that a label names.
    /// </summary>
    /// <param name="path">The path; links are resolved.</param>
    public bool Holds(string path)
    {
        string name = Path.GetRelativePath(InnerPath.Resolve(Folder), InnerPath.Resolve(path)).Replace('\\', '/');
        return name is SessionInfo.FileName or LabelsFile
            || ((string[])[FramePaths.Frames, FramePaths.Masks, FramePaths.Scenes])
                .Contains(name.Split('/')[0], StringComparer.OrdinalIgnoreCase)
            || (InnerPath.IsWithin(Folder, name)
                && ReadLines().Any(line => line.Label is { } label && (label.Image == name || label.Mask == name)));
    }

    /// <summary>Reads session.json.</summary>
    /// <exception cref="DatasetFormatException">It is not what its format asks for; the message names file and field.</exception>
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
    /// <exception cref="DatasetFormatException">A line cannot be read; the message names file, line and field.</exception>
    public IEnumerable<FrameLabel> ReadLabels() => ReadGoodLines().Select(line => line.Label!);

    /// <summary>The labels with the text that they were read from, in the order of the file.</summary>
    /// <exception cref="DatasetFormatException">A line cannot be read; the message names file, line and field.</exception>
    public IEnumerable<LabelLine> ReadGoodLines() => ReadLines().Select(line =>
        (line.Problem ?? IdProblem(line.Label!)) is { } problem
            ? throw new DatasetFormatException($"{PathOf(LabelsFile)}, line {line.Number}: {problem}")
            : line);

    /// <summary>The lines of labels, those that cannot be read included; none when not one frame was written.</summary>
    public IEnumerable<LabelLine> ReadLines() => ReadTexts().Select((line, index) => ReadLine(index + 1, line));

    /// <summary>How many lines of labels there are, good or not.</summary>
    public int CountLines() => ReadTexts().Count();

    /// <summary>The lines of labels as they stand there, without one that has no end.</summary>
    internal IEnumerable<string> ReadTexts()
    {
        string path = PathOf(LabelsFile);
        return !File.Exists(path) ? [] : HasUnfinishedLine ? InputFile.ReadLines(path).SkipLast(1) : InputFile.ReadLines(path);
    }

    /// <summary>Objects are looked up by their ids, which are the numbers in masks.</summary>
    private static string? IdProblem(FrameLabel label)
    {
        var seen = new HashSet<int>();
        return label.Objects.FirstOrDefault(item => item.Id is < 1 or > ushort.MaxValue || !seen.Add(item.Id)) is not { } item ? null
            : seen.Contains(item.Id) ? $"two objects have the id {item.Id}."
            : $"an object has the id {item.Id}; ids are 1 to {ushort.MaxValue}.";
    }

    private static LabelLine ReadLine(int number, string line)
    {
        try
        {
            return new LabelLine(number, line, FrameLabelParser.Parse(line), null);
        }
        catch (DatasetFormatException e)
        {
            return new LabelLine(number, line, null, e.Message);
        }
    }
}
