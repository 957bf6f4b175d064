using Harvester.Exports;
using Harvester.Exports.Formats.Kitti;
using Harvester.Geometry;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Comparison;

/// <summary>The labels of KITTI's object detection as a dataset to compare; the images too where they are beside them.</summary>
public sealed class ComparedKitti : IComparedDataset
{
    private const int Columns = 15;
    private const int Truncated = 0;
    private const int Occluded = 1;
    private const int Alpha = 2;
    private const int Left = 3;
    private const int Height = 7;
    private const int X = 10;
    private const double Unknown = -10;
    private const double UnknownPlace = -1000;
    private static readonly string[] ImageExtensions = [".png", ".jpg", ".bmp"];

    private readonly string _name;
    private readonly string[] _files;

    private ComparedKitti(string name, string labels, string[] files)
    {
        _name = name;
        _files = files;
        string images = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(labels))!, "image_2");
        Images =
        [
            .. EvenSelection
                .Of(files.Length, ImageBrightness.MaxImages)
                .SelectMany(index =>
                    ImageExtensions.Select(extension => Path.Combine(images, Path.GetFileNameWithoutExtension(files[index]) + extension))
                )
                .Where(File.Exists),
        ];
    }

    /// <inheritdoc />
    public int Length => _files.Length;

    /// <inheritdoc />
    public string Unit => "files";

    /// <inheritdoc />
    public IReadOnlyList<string> Images { get; }

    /// <summary>Opens a dataset.</summary>
    /// <param name="folder">The folder label_2, or one with label_2 or training/label_2.</param>
    /// <exception cref="DirectoryNotFoundException">There is no such folder.</exception>
    /// <exception cref="DatasetFormatException">It has no label files.</exception>
    public static ComparedKitti Open(string folder)
    {
        if (!Directory.Exists(folder))
        {
            throw new DirectoryNotFoundException($"Folder not found: '{folder}'.");
        }

        string labels = new[] { Path.Combine(folder, "training", "label_2"), Path.Combine(folder, "label_2") }.FirstOrDefault(
            Directory.Exists,
            folder
        );
        string[] files = [.. Directory.EnumerateFiles(labels, "*.txt").Order(StringComparer.Ordinal)];
        return files.Length > 0
            ? new ComparedKitti(Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder))), labels, files)
            : throw new DatasetFormatException($"'{labels}' has no label files (*.txt). Name a folder label_2, or the one above it.");
    }

    /// <inheritdoc />
    public DatasetProfile Read(Action<int> report, CancellationToken cancellation)
    {
        var profile = new DatasetProfile(_name);
        foreach ((int index, string file) in _files.Index())
        {
            cancellation.ThrowIfCancellationRequested();
            int objects = 0;
            foreach ((int line, string text) in InputFile.ReadLines(file).Index())
            {
                string[] words = text.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
                if (words.Length > 0 && words[0] != KittiClasses.DontCare)
                {
                    profile.Add(Parse(words, problem => new DatasetFormatException($"'{file}', line {line + 1}: {problem}")));
                    objects++;
                }
            }

            profile.AddFrame(objects);
            report(index + 1);
        }

        return profile;
    }

    private static ComparedObject Parse(string[] words, Func<string, DatasetFormatException> problem)
    {
        if (words.Length is not (Columns or Columns + 1))
        {
            throw problem($"it has {words.Length} columns instead of {Columns}.");
        }

        if (Numbers.Parse(words.Skip(1)) is not { } numbers)
        {
            throw problem("a column after the type is not a finite number.");
        }

        var box = new Box2D(numbers[Left], numbers[Left + 1], numbers[Left + 2], numbers[Left + 3]);
        if (box.Width < 0 || box.Height < 0)
        {
            throw problem("right or bottom is less than left or top.");
        }

        // KITTI gives the middle of the bottom face; y points down.
        var centre = new Vector3D(numbers[X], numbers[X + 1] - (numbers[Height] / 2), numbers[X + 2]);
        return new ComparedObject(
            words[0],
            words[0],
            box,
            numbers[X] == UnknownPlace ? null : centre.Length,
            numbers[Truncated] < 0 ? null : numbers[Truncated],
            null,
            ClassScheme.LevelOfKitti(numbers[Occluded]),
            numbers[Alpha] == Unknown ? null : numbers[Alpha]
        );
    }
}
