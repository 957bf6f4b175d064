using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Harvester.Capture.Storage;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Surveys.Faces;

/// <summary>
/// What a user has measured, in a folder: the rows in faces.csv, one line for each model that a survey is done with in models.txt, and
/// photographs. Tables are written anew after each model under a temporary name and renamed, so a survey that is cut off goes on
/// where it was. All writing is on another thread; a failure of it is thrown by the next call that writes.
/// </summary>
public sealed class SurveyFolder
{
    /// <summary>File of the measured rows.</summary>
    public const string TableName = "spaces.csv";

    private const string DoneName = "models.txt";
    private readonly string _path;
    private readonly List<string> _done = [];
    private readonly DiskQueue _disk = new();
    private readonly Dictionary<string, SurveyPhoto> _photos = new(StringComparer.Ordinal);

    /// <summary>Opens a folder, made if it is not there, with what an earlier survey has left in it. This reads the disk at once.</summary>
    /// <exception cref="IOException">A file cannot be read, or a row of a table is refused: it would be lost.</exception>
    public SurveyFolder(string path)
    {
        _path = path;
        Directory.CreateDirectory(Path.Combine(path, SurveyPhoto.FolderName));
        string done = Path.Combine(path, DoneName);
        if (File.Exists(done))
        {
            _done.AddRange(File.ReadAllLines(done).Where(line => line.Length > 0));
        }

        string table = Path.Combine(path, TableName);
        if (File.Exists(table))
        {
            using StreamReader text = File.OpenText(table);
            FaceTableContent content = FaceTableReader.Read(text);
            Table = content.Problems.Count == 0
                ? content.Table
                : throw new IOException($"{table}: {content.Problems[0]} Correct or remove the row, then survey again.");
        }

        foreach (SurveyPhoto photo in SurveyPhoto.ReadAll(path))
        {
            _photos[photo.File] = photo;
        }
    }

    /// <summary>The rows measured so far.</summary>
    public FaceTable Table { get; private set; } = FaceTable.Empty;

    /// <summary>Whether something is still being written.</summary>
    public bool IsWriting => _disk.IsBusy;

    /// <summary>Whether a model is done, with or without a face found.</summary>
    public bool IsDone(string model) => _done.Any(line => ModelOf(line) == model);

    /// <summary>Notes that a model is done.</summary>
    /// <param name="model">The model's name.</param>
    /// <param name="outcome">What came of it, in a few words.</param>
    /// <param name="faces">The model's faces; where there are any they take the place of its earlier ones.</param>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Finish(string model, string outcome, IReadOnlyList<ModelFace> faces)
    {
        _done.RemoveAll(line => ModelOf(line) == model);
        _done.Add($"{model} {outcome}");
        Table = faces.Count > 0 ? Table.OverriddenBy(new FaceTable(faces)) : Table;
        FaceTable table = Table;
        string done = string.Join("\n", _done) + "\n";
        Write(TableName, text => FaceTableWriter.Write(table, text));
        Write(DoneName, text => text.Write(done));
    }

    /// <summary>Keeps a photograph.</summary>
    /// <param name="photo">Of what, and from where.</param>
    /// <param name="picture">Its pixels; not to be changed any more.</param>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Keep(SurveyPhoto photo, PixelBuffer picture)
    {
        _photos[(photo ?? throw new ArgumentNullException(nameof(photo))).File] = photo;
        SurveyPhoto[] photos = [.. _photos.Values];
        WriteFile(Path.Combine(SurveyPhoto.FolderName, photo.File), stream => new PngEncoder().Write(picture, stream));
        Write(SurveyPhoto.TableName, text => SurveyPhoto.Write(photos, text));
    }

    /// <summary>Waits until all is written, at most so long.</summary>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Wait(TimeSpan longest)
    {
        _disk.Wait(longest);
        ThrowFailure();
    }

    private static string ModelOf(string line) => line.Split(' ')[0];

    private void Write(string name, Action<TextWriter> content) => WriteFile(name, stream =>
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), 4096, leaveOpen: true);
        content(text);
    });

    private void WriteFile(string name, Action<Stream> content)
    {
        ThrowFailure();
        _disk.Add(() => AtomicFile.Write(Path.Combine(_path, name), content));
    }

    private void ThrowFailure()
    {
        if (_disk.TakeFailure() is { } failure)
        {
            throw new IOException(failure.Message, failure);
        }
    }
}
