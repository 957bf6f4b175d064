using Harvester.Capture.Surveys;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;

namespace Harvester.Play.Surveys.Paint;

/// <summary>A survey of paint that is ready to begin.</summary>
/// <param name="Plan">The pictures that are left.</param>
/// <param name="Earlier">Number of pictures of earlier surveys.</param>
public sealed record PreparedSurvey(StationPlan Plan, int Earlier)
{
    /// <summary>The folder of its session, which is not there yet.</summary>
    public string Folder { get; init; } = "";

    /// <summary>Reads the roads and the earlier pictures, and plans those that are left. It takes a while: for another thread.</summary>
    /// <param name="roadFile">The file of the roads.</param>
    /// <param name="folder">The folder of the sessions of all surveys of paint.</param>
    /// <param name="view">The camera.</param>
    /// <param name="near">The player's place, metres, world.</param>
    /// <param name="rangeMetres">Roads farther from there are left out, metres; null for none.</param>
    /// <exception cref="IOException">A file is missing or cannot be read; the message is for the player.</exception>
    /// <exception cref="FormatException">A file is damaged; the message is for the player.</exception>
    public static PreparedSurvey Of(string roadFile, string folder, SurveyView view, Vector3D near, double? rangeMetres)
    {
        RoadNetwork network =
            RoadSurveyFile.Load(roadFile)
            ?? throw new FileNotFoundException(
                $"No roads are known: there is no {roadFile}. Survey the roads first, or name a road file under [Roads]."
            );
        IReadOnlyList<SurveyStation> earlier = EarlierPictures.In(folder, view);
        var plan = StationPlan.Of(
            new PaintRoads(new RoadCurves(network)),
            (view ?? throw new ArgumentNullException(nameof(view))).Footprint,
            new Vector2D(near.X, near.Y),
            rangeMetres ?? double.MaxValue,
            earlier
        );
        return new PreparedSurvey(plan, earlier.Count);
    }
}
