using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Harvester.Capture.Storage;

namespace Harvester.Capture.Spaces.Survey;

/// <summary>
/// What a survey has found, in a folder: the measured rows in spaces.csv, and one line for each model that is done in models.txt. Both are
/// written anew after each model under a temporary name and renamed, so a survey that is cut off goes on where it was.
/// </summary>
public sealed class SurveyFolder
{
    /// <summary>File of the measured rows.</summary>
    public const string TableName = "spaces.csv";

    private const string DoneName = "models.txt";
    private readonly string _path;
    private readonly List<string> _done = [];

    /// <summary>Opens a folder, made if it is not there, with what an earlier survey has left in it.</summary>
    /// <exception cref="IOException">A file cannot be read, or a row of the table is refused: it would be lost.</exception>
    public SurveyFolder(string path)
    {
        _path = path;
        Directory.CreateDirectory(path);
        string done = Path.Combine(path, DoneName);
        if (File.Exists(done))
        {
            _done.AddRange(File.ReadAllLines(done).Where(line => line.Length > 0));
        }

        string table = Path.Combine(path, TableName);
        if (File.Exists(table))
        {
            using StreamReader text = File.OpenText(table);
            SpaceTableContent content = SpaceTableReader.Read(text);
            Table = content.Problems.Count == 0
                ? content.Table
                : throw new IOException($"{table}: {content.Problems[0]} Mend or remove the row, then survey again.");
        }
    }

    /// <summary>The rows measured so far.</summary>
    public SpaceTable Table { get; private set; } = SpaceTable.Empty;

    /// <summary>Whether a model is done, with or without a face found.</summary>
    public bool IsDone(string model) => _done.Any(line => line.Split(' ')[0] == model);

    /// <summary>Notes that a model is done.</summary>
    /// <param name="model">The model's name.</param>
    /// <param name="outcome">What came of it, in a few words.</param>
    /// <param name="spaces">The spaces found; they take the place of the model's earlier ones.</param>
    /// <exception cref="IOException">The files cannot be written.</exception>
    public void Finish(string model, string outcome, IReadOnlyList<SpaceOfInterest> spaces)
    {
        Table = Table.OverriddenBy(new SpaceTable(spaces));
        _done.Add($"{model} {outcome}");
        using var files = new SessionDirectory(_path);
        files.WriteWhole(TableName, stream => Write(stream, text => SpaceTableWriter.Write(Table, text)));
        files.WriteWhole(DoneName, stream => Write(stream, text => text.Write(string.Join("\n", _done) + "\n")));
    }

    private static void Write(Stream stream, Action<TextWriter> content)
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), 4096, leaveOpen: true);
        content(text);
    }
}
