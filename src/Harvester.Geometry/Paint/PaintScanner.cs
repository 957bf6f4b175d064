using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Looks for stripes in images. Around each image the ground is unrolled along the links of the road network, row by row across the road;
/// each row is a profile of brightness over the offset, in which a <see cref="StripeFinder"/> finds the stripes. Use one scanner per
/// thread.
/// </summary>
public sealed class PaintScanner
{
    /// <summary>
    /// Farthest row that is scanned, metres from the camera: beyond it, the height of the ground is not known well enough.
    /// </summary>
    public const double MaxDistance = 30;

    /// <summary>Widest pixel across the road, metres: two of them are the narrowest paint.</summary>
    private const double MaxPixelAcross = 0.05;

    /// <summary>Longest pixel along the road, metres: longer ones blur dashes into their gaps.</summary>
    private const double MaxPixelAlong = 1.2;

    /// <summary>
    /// What is higher than this stands on the ground even where the fraction of the depth allows more, as seen from above, metres: parapets
    /// and rails are 60 cm and more, kerbs 15 cm.
    /// </summary>
    private const double MaxRelief = 0.3;

    /// <summary>Profiles that are averaged for a row: a single one has the noise of single pixels.</summary>
    private const int ProfilesPerRow = 3;

    /// <summary>Standard deviation of the position of an edge, pixels.</summary>
    private const double EdgeSigma = 0.3;

    /// <summary>Ground where offsets are less sure than this is not searched, metres: a twelfth of the narrowest lane.</summary>
    private const double MaxSigma = 0.25;

    /// <summary>
    /// Ground seen beside a stripe on both sides, metres: the other stripe of a double line is no farther away, so that of a double line
    /// both stripes are seen or neither.
    /// </summary>
    private const double Margin = 0.6;

    private readonly PaintRoads _roads;
    private readonly StripeFinder _finder = StripeFinder.OfLines();
    private readonly List<StripeFinder.Stripe> _stripes = [];
    private readonly GroundProfile _profile = new();
    private readonly MarkScanner _marks;

    /// <summary>Creates a scanner.</summary>
    /// <param name="roads">The roads.</param>
    public PaintScanner(PaintRoads roads)
    {
        _roads = Guard.NotNull(roads, nameof(roads));
        _marks = new MarkScanner(roads.Mouths, _profile);
    }

    /// <summary>Scans an image.</summary>
    /// <param name="image">The image.</param>
    /// <param name="number">Number of the image, which its stripes keep.</param>
    /// <param name="evidence">Receives what is seen.</param>
    public void Scan(PaintImage image, int number, PaintEvidence evidence)
    {
        Guard.NotNull(image, nameof(image));
        Guard.NotNull(evidence, nameof(evidence));
        Vector3D camera = image.Camera.Pose.Position;
        foreach (int link in (IEnumerable<int>)_roads.Near(camera))
        {
            RoadCurve curve = _roads.Curves.Of(link);
            if (curve.IsBeyond(new Vector2D(camera.X, camera.Y), MaxDistance))
            {
                continue;
            }

            for (int row = 0; row < _roads.RowsOf(link); row++)
            {
                double station = _roads.StationOf(link, row);
                if (!_roads.Junctions.Contains(link, station))
                {
                    ScanRow(image, number, link, row, station, evidence);
                }
            }
        }

        _marks.Scan(image, number, evidence.Marks);
    }

    private void ScanRow(PaintImage image, int number, int link, int row, double station, PaintEvidence evidence)
    {
        RoadCurve curve = _roads.Curves.Of(link);
        double parameter = curve.ParameterAt(station);
        Vector3D centre = curve.PointAt(parameter);
        Vector3D from = image.Camera.Pose.Position;
        (double x, double y) = (centre.X - from.X, centre.Y - from.Y);
        double ground = Math.Sqrt((x * x) + (y * y));
        if (ground > MaxDistance)
        {
            return;
        }

        // Distance of the camera from the plane of the road in this row, which has the slope of the link's line.
        Vector2D direction = curve.DirectionAt(parameter);
        double slope = curve.Slope;
        double level = image.Ground.HeightAt(centre);
        double rise = (double.IsNaN(level) ? centre.Z : level) - from.Z;
        double height = ((((x * direction.X) + (y * direction.Y)) * slope) - rise) / Math.Sqrt(1 + (slope * slope));
        double distance = Math.Sqrt((ground * ground) + (rise * rise));
        double focal = image.Camera.Intrinsics.Fx;

        // A pixel covers d / f metres across the line of sight, and d / h times as much along it on the ground.
        double across = distance / focal;
        double along = across * distance / Math.Max(0.1, height);
        if (height <= 0 || across > MaxPixelAcross || along > MaxPixelAlong)
        {
            return;
        }

        (float left, float right) = _roads.ReachAt(link, station);
        int cells = (int)((right - left) / StripeFinder.Cell);
        _profile.Clear(cells);

        // What is seen at depth d in front of ground at depth g is h (1 - d / g) high.
        _profile.DepthTolerance = Math.Min(GroundProfile.MaxDepthTolerance, MaxRelief / height);
        for (int i = 0; i < ProfilesPerRow; i++)
        {
            double shift = (((i + 0.5) / ProfilesPerRow) - 0.5) * PaintRow.Length;
            double place = curve.ParameterAt(station + shift);
            _profile.Add(image, offset => curve.PointBeside(place, offset), left, cells);
        }

        _profile.Average(cells, ProfilesPerRow);
        double cameraOffset = -((x * direction.Y) - (y * direction.X));
        var seen = new SeenSpan(
            number,
            0,
            0,
            (float)cameraOffset,
            (float)(EdgeSigma * across),
            (float)(image.Ground.SigmaAt(ground) / height)
        );
        for (int cell = 0; cell < cells; cell++)
        {
            if (seen.SigmaAt(left + (cell * StripeFinder.Cell)) > MaxSigma)
            {
                _profile.Count[cell] = 0;
            }
        }

        (int Begin, int End) run = _profile.NextSeen(0, cells, ProfilesPerRow);
        while (run.Begin < run.End)
        {
            AddRun(link, row, left, run.Begin, run.End, seen, evidence);
            run = _profile.NextSeen(run.End, cells, ProfilesPerRow);
        }
    }

    private void AddRun(int link, int row, float left, int begin, int end, SeenSpan seen, PaintEvidence evidence)
    {
        double OffsetOf(double cell) => left + (cell * StripeFinder.Cell);
        float first = (float)(OffsetOf(begin) + Margin);
        float last = (float)(OffsetOf(end) - Margin);
        if (first >= last)
        {
            return;
        }

        _stripes.Clear();
        _finder.Find(_profile.Bright, _profile.Blue, begin, end, _stripes);
        evidence.Add(link, row, seen with { Left = first, Right = last });
        foreach (StripeFinder.Stripe stripe in _stripes)
        {
            float middle = (float)OffsetOf((stripe.Left + stripe.Right) / 2);
            if (middle >= first && middle <= last)
            {
                float width = (float)((stripe.Right - stripe.Left) * StripeFinder.Cell);
                float sigma = (float)seen.SigmaAt(middle);
                evidence.Add(
                    link,
                    row,
                    new PaintCandidate(seen.Image, middle, width, (float)stripe.Contrast, (float)stripe.Blueness, sigma)
                );
            }
        }
    }
}
