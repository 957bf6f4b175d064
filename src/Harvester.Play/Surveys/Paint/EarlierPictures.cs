using Harvester.Capture.Surveys;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Text;

namespace Harvester.Play.Surveys.Paint;

/// <summary>The pictures of earlier surveys of paint, by which the next one knows what is left.</summary>
public static class EarlierPictures
{
    private const string Labels = "labels.jsonl";

    /// <summary>A camera whose height differs by more than this fraction belongs to a survey with other pictures.</summary>
    private const double HeightTolerance = 0.1;

    /// <summary>The stations of all sessions in a folder. A line that is cut off or damaged stands for no picture.</summary>
    /// <param name="folder">The folder; it need not exist.</param>
    /// <param name="view">The camera; pictures from other heights are left out.</param>
    /// <exception cref="IOException">A session cannot be read.</exception>
    public static IReadOnlyList<SurveyStation> In(string folder, SurveyView view)
    {
        double height = (view ?? throw new ArgumentNullException(nameof(view))).HeightMetres;
        if (!Directory.Exists(folder))
        {
            return [];
        }

        return
        [
            .. Directory
                .GetDirectories(folder)
                .Select(session => Path.Combine(session, Labels))
                .Where(File.Exists)
                .OrderBy(file => file, StringComparer.Ordinal)
                .SelectMany(File.ReadLines)
                .Select(line => StationIn(line, height))
                .OfType<SurveyStation>(),
        ];
    }

    /// <summary>The station of a label: the camera is above the vehicle, and the image's right side looks along the road.</summary>
    private static SurveyStation? StationIn(string line, double height)
    {
        (Vector3D camera, Vector3D right, Vector3D ego) = (default, default, default);
        try
        {
            var json = new JsonReader(line);
            json.Object(field =>
            {
                if (field is "camera" or "ego")
                {
                    json.Object(part =>
                    {
                        switch (field, part)
                        {
                            case ("camera", "position"):
                                camera = VectorIn(json);
                                break;
                            case ("camera", "right"):
                                right = VectorIn(json);
                                break;
                            case ("ego", "position"):
                                ego = VectorIn(json);
                                break;
                            default:
                                json.Skip();
                                break;
                        }
                    });
                }
                else
                {
                    json.Skip();
                }
            });
        }
        catch (FormatException)
        {
            return null;
        }

        var along = new Vector2D(right.X, right.Y);
        return along.Length > 0 && Math.Abs((camera - ego).Length - height) <= HeightTolerance * height
            ? new SurveyStation(ego, along * (1 / along.Length))
            : null;
    }

    private static Vector3D VectorIn(JsonReader json)
    {
        var values = new List<double>();
        json.List(() => values.Add(json.Number()));
        return values.Count == 3
            ? new Vector3D(values[0], values[1], values[2])
            : throw new FormatException("A position has three numbers.");
    }
}
