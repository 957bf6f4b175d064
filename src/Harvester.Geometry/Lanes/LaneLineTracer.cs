namespace Harvester.Geometry.Lanes;

/// <summary>
/// Traces the boundaries of all lanes of a stretch of road. A boundary continues from link to link while its number exists. Where a road
/// gains or loses a lane, a boundary begins or ends; in a junction there are no boundaries.
/// </summary>
public static class LaneLineTracer
{
    /// <summary>Distance of points near the camera, metres: keeps a line within a pixel of the curve from 5 m on.</summary>
    private const double NearStep = 0.5;

    /// <summary>Distance of points beyond <see cref="NearReach"/>, metres.</summary>
    private const double FarStep = 2;
    private const double NearReach = 20;

    /// <summary>Traces the boundaries between two stations, each as runs of points.</summary>
    /// <param name="stretch">The road.</param>
    /// <param name="carOffset">The car's position, metres to the right of the centre line.</param>
    /// <param name="from">First station, metres along the road from the car.</param>
    /// <param name="to">Last station.</param>
    public static IReadOnlyList<LaneLine> Trace(RoadStretch stretch, double carOffset, double from, double to)
    {
        Guard.NotNull(stretch, nameof(stretch));
        var runs = new LineRuns();
        double end = Math.Min(to, stretch.EndStation);
        for (double station = Math.Max(from, stretch.StartStation); ; station = Math.Min(end, station + StepAt(station)))
        {
            StretchPiece piece = stretch.PieceAt(station)!;
            IReadOnlyDictionary<int, double> boundaries = piece.IsInJunction(station) ? NoBoundaries : piece.BoundariesAt(station);
            runs.EndAllBut(boundaries.Keys);
            double parameter = piece.ParameterAt(station);
            foreach (KeyValuePair<int, double> boundary in boundaries)
            {
                runs.Add(
                    boundary.Key,
                    boundary.Value < carOffset,
                    new LinePoint(piece.PointBeside(parameter, boundary.Value), IsPainted: false)
                );
            }

            if (station >= end)
            {
                break;
            }
        }

        return runs.Lines();
    }

    /// <summary>Distance of the points of lines at a station, metres.</summary>
    internal static double StepAt(double station) => Math.Abs(station) < NearReach ? NearStep : FarStep;

    private static Dictionary<int, double> NoBoundaries { get; } = [];
}
