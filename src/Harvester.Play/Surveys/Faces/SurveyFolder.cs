using System.Text;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// A folder with a user's measurements: the rows in spaces.csv, one line for each finished model in models.txt, and photographs. After each
/// model, the tables are written under temporary names and renamed, so an interrupted survey continues where it was. All writing is done on
/// another thread; its failure is thrown by the next call that writes.
/// </summary>
public sealed class SurveyFolder
{
    /// <summary>File of the measured rows.</summary>
    public const string TableName = FaceTable.FileName;

    private const string DoneName = "models.txt";
    private readonly string _path;
    private readonly List<string> _done = [];
    private readonly DiskQueue _disk = new();
    private readonly Dictionary<string, SurveyPhoto> _photos = new(StringComparer.Ordinal);

    /// <summary>Opens a folder with the results of an earlier survey, or creates it. Reads the disk immediately.</summary>
    /// <exception cref="IOException">A file cannot be read, or a row of a table is invalid and would be lost.</exception>
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
            Table =
                content.Problems.Count == 0
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
    public bool IsWriting => !Background.IsDone(nameof(IsWriting), () => !_disk.IsBusy);

    /// <summary>Whether a model is done, with or without a face found.</summary>
    public bool IsDone(string model) => _done.Any(line => ModelOf(line) == model);

    /// <summary>Records that a model is done.</summary>
    /// <param name="model">The model's name.</param>
    /// <param name="outcome">The outcome, in a few words.</param>
    /// <param name="faces">The model's faces; if there are any, they replace its earlier ones.</param>
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

    /// <summary>Stores a photograph.</summary>
    /// <param name="photo">The model and the camera.</param>
    /// <param name="picture">Its pixels; must not be changed any more.</param>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Keep(SurveyPhoto photo, PixelBuffer picture)
    {
        _photos[(photo ?? throw new ArgumentNullException(nameof(photo))).File] = photo;
        SurveyPhoto[] photos = [.. _photos.Values];
        WriteFile(Path.Combine(SurveyPhoto.FolderName, photo.File), stream => new PngEncoder().Write(picture, stream));
        Write(SurveyPhoto.TableName, text => SurveyPhoto.Write(photos, text));
    }

    /// <summary>Waits until everything is written, or until the time is over.</summary>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Wait(TimeSpan timeout)
    {
        _disk.Wait(timeout);
        ThrowFailure();
    }

    private static string ModelOf(string line) => line.Split(' ')[0];

    private void Write(string name, Action<TextWriter> content) =>
        WriteFile(
            name,
            stream =>
            {
                using var text = new StreamWriter(stream, new UTF8Encoding(false), 4096, leaveOpen: true);
                content(text);
            }
        );

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
