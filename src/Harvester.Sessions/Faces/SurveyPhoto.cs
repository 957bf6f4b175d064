using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Faces;

/// <summary>A square photograph of a model, with the camera with which cuboids are drawn on it.</summary>
/// <param name="File">Name of the file in the folder of photographs.</param>
/// <param name="Model">The model's name.</param>
/// <param name="Camera">Position (metres) and orientation of the camera in the model's frame.</param>
/// <param name="VerticalFovDegrees">Vertical and horizontal field of view, degrees.</param>
public sealed record SurveyPhoto(string File, string Model, Pose Camera, double VerticalFovDegrees)
{
    /// <summary>The subfolder of photographs.</summary>
    public const string FolderName = "photos";

    /// <summary>The file with the camera of each photograph, in the folder of the measured rows.</summary>
    public const string TableName = "photos.csv";

    private const string Header = "file,model,x,y,z,pitch,roll,yaw,verticalFov";
    private const int Decimals = 6;
    private const int Fields = 9;

    /// <summary>Positions are within metres of a model; NaN and infinity are no position.</summary>
    private const double MaxNumber = 1e6;
    private const double MinFovDegrees = 0.1;
    private const double MaxFovDegrees = 179;

    /// <summary>The photographs listed in a folder; invalid lines are ignored, since only a drawing is lost with them.</summary>
    /// <param name="folder">The folder of the measured rows.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static IReadOnlyList<SurveyPhoto> ReadAll(string folder)
    {
        string table = Path.Combine(folder, TableName);
        if (!System.IO.File.Exists(table))
        {
            return [];
        }

        using var text = new StreamReader(RegularFile.OpenRead(table));
        return ReadAll(text);
    }

    /// <summary>The photographs listed in an open table.</summary>
    public static IReadOnlyList<SurveyPhoto> ReadAll(TextReader table)
    {
        var photos = new List<SurveyPhoto>();
        while (table.ReadLine() is { } line)
        {
            if (Parse(line) is { } photo)
            {
                photos.Add(photo);
            }
        }

        return photos;
    }

    /// <summary>Writes the table of photographs, ordered by file name.</summary>
    internal static void Write(IEnumerable<SurveyPhoto> photos, TextWriter text)
    {
        text.Write(Header + "\n");
        foreach (SurveyPhoto photo in photos.OrderBy(photo => photo.File, StringComparer.Ordinal))
        {
            EulerAngles angles = photo.Camera.Axes.ToEuler();
            Vector3D place = photo.Camera.Position;
            double[] numbers =
            [
                place.X,
                place.Y,
                place.Z,
                angles.PitchDegrees,
                angles.RollDegrees,
                angles.YawDegrees,
                photo.VerticalFovDegrees,
            ];
            string row = string.Join(",", numbers.Select(number => InvariantNumber.Format(number, Decimals)));
            text.Write($"{photo.File},{photo.Model},{row}\n");
        }
    }

    private static SurveyPhoto? Parse(string line)
    {
        string[] fields = line.Split(',');
        var numbers = new List<double>();
        foreach (string field in fields.Skip(2))
        {
            if (
                double.TryParse(field, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                && Math.Abs(number) <= MaxNumber
            )
            {
                numbers.Add(number);
            }
        }

        return fields.Length != Fields || numbers.Count != Fields - 2 || numbers[6] is not (>= MinFovDegrees and <= MaxFovDegrees)
            ? null
            : new SurveyPhoto(
                fields[0],
                fields[1],
                new Pose(
                    new Vector3D(numbers[0], numbers[1], numbers[2]),
                    Axes.FromEuler(new EulerAngles(numbers[3], numbers[4], numbers[5]))
                ),
                numbers[6]
            );
    }
}
