using System.Globalization;
using Harvester.Datasets.Detections;
using Harvester.Exports.Formats.Kitti;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Predictions;

/// <summary>
/// Predictions as KITTI results: a label file per frame, with a score at the end of each line. Files are read one at a time.
/// </summary>
internal sealed class KittiPredictions : IPredictions
{
    private const int Columns = 16;
    private const int Left = 3;
    private const int Score = 14;

    /// <summary>No pixel, metre or score is as large.</summary>
    private const double MaxMagnitude = 1e9;

    private readonly string _folder;
    private readonly ExportOptions _options;
    private readonly SortedDictionary<int, string> _files;
    private readonly Dictionary<string, int> _places;

    private KittiPredictions(string folder, ExportOptions options, SortedDictionary<int, string> files)
    {
        _folder = folder;
        _options = options;
        _files = files;
        Classes = [.. KittiClasses.Types.Select(type => new PredictedClass(type, KindOf(type)))];
        _places = Classes.Index().ToDictionary(kind => kind.Item.Name, kind => kind.Index, StringComparer.Ordinal);
    }

    public string Format => "KITTI";

    public IReadOnlyList<PredictedClass> Classes { get; }

    public double ToSessionPixels => -KittiBox.PixelShift;

    /// <summary>Lists the files of a folder.</summary>
    /// <exception cref="DatasetFormatException">There are none, or a name is not the number of a frame.</exception>
    public static KittiPredictions Open(string folder, ExportOptions options)
    {
        var files = new SortedDictionary<int, string>();
        foreach (string file in Directory.EnumerateFiles(folder, "*.txt").Order(StringComparer.Ordinal))
        {
            if (
                !int.TryParse(Path.GetFileNameWithoutExtension(file), NumberStyles.None, CultureInfo.InvariantCulture, out int number)
                || !files.TryAdd(number, file)
            )
            {
                throw new DatasetFormatException($"'{file}' is not named by the number of a frame, such as 000012.txt.");
            }
        }

        return files.Count > 0
            ? new KittiPredictions(folder, options, files)
            : throw new DatasetFormatException(
                $"'{folder}' has no files with predictions; they are named by the number of their frame, such as 000012.txt."
            );
    }

    public int? ImageOf(ExportFrame frame)
    {
        KittiPlace place = KittiPlace.Of(frame);
        return place.IsReference ? frame.Index + place.ToReference : null;
    }

    public IEnumerable<TruthObject> TruthOf(ExportFrame frame)
    {
        foreach (KittiBox item in KittiBox.Of(frame, _options.Names))
        {
            Box2D box = Rounded(item.Box);
            yield return new TruthObject(new TruthBox(_places[item.Type], box, box.Area, IsCrowd: false), item.Label);
        }

        // DontCare has no type: no prediction of any class counts there.
        foreach (Box2D box in KittiBox.IgnoredIn(frame).Select(Rounded))
        {
            for (int place = 0; place < Classes.Count; place++)
            {
                yield return new TruthObject(new TruthBox(place, box, box.Area, IsCrowd: true), null);
            }
        }
    }

    public IReadOnlyList<PredictedBox> For(int image)
    {
        if (!_files.TryGetValue(image, out string? file))
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"'{_folder}' has no {image:D6}.txt. A frame without predictions needs an empty file.")
            );
        }

        var boxes = new List<PredictedBox>();
        foreach ((int index, string line) in InputFile.ReadLines(file).Index())
        {
            string[] words = line.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
            if (words.Length > 0 && words[0] != KittiClasses.DontCare)
            {
                boxes.Add(Parse(words, image, problem => new DatasetFormatException($"'{file}', line {index + 1}: {problem}")));
            }
        }

        return boxes;
    }

    public void CheckImages(IReadOnlySet<int> images)
    {
        foreach ((int number, string file) in _files)
        {
            if (!images.Contains(number))
            {
                throw new DatasetFormatException($"'{file}' belongs to no frame that the KITTI export of the session labels.");
            }
        }
    }

    private PredictedBox Parse(string[] words, int image, Func<string, DatasetFormatException> problem)
    {
        if (words.Length != Columns)
        {
            throw problem($"it has {words.Length} columns instead of {Columns}; the last is the score.");
        }

        if (!_places.TryGetValue(words[0], out int place))
        {
            throw problem($"type '{words[0]}' is unknown. Types are {string.Join(", ", KittiClasses.Types)} and {KittiClasses.DontCare}.");
        }

        if (Numbers.Parse(words.Skip(1)) is not { } numbers || Array.Exists(numbers, number => Math.Abs(number) > MaxMagnitude))
        {
            throw problem("a column after the type is not a number from -1e9 to 1e9.");
        }

        (double left, double top, double right, double bottom) = (numbers[Left], numbers[Left + 1], numbers[Left + 2], numbers[Left + 3]);
        return right >= left && bottom >= top
            ? new PredictedBox(image, place, new Box2D(left, top, right, bottom), numbers[Score])
            : throw problem("right or bottom is less than left or top.");
    }

    /// <summary>A box as the file of the export has it.</summary>
    private static Box2D Rounded(Box2D box) => new(Rounded(box.XMin), Rounded(box.YMin), Rounded(box.XMax), Rounded(box.YMax));

    private static double Rounded(double side) => Numbers.Rounded(KittiDecimals.Pixels, side);

    private static ObjectClass KindOf(string type) =>
        type switch
        {
            "Car" => ObjectClass.Car,
            "Van" => ObjectClass.Bus,
            "Truck" => ObjectClass.Truck,
            "Pedestrian" => ObjectClass.Pedestrian,
            "Person_sitting" => ObjectClass.Motorcycle,
            "Cyclist" => ObjectClass.Bicycle,
            "Tram" => ObjectClass.Trailer,
            _ => ObjectClass.Other,
        };
}
