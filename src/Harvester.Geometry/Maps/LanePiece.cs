namespace Harvester.Geometry.Maps;

/// <summary>Where a place lies beside a lane: at the piece of the lane's middle that is nearest to it.</summary>
/// <param name="Direction">The lane's direction there, not of unit length.</param>
/// <param name="FromMiddle">Distance from the lane's middle on the ground, metres.</param>
/// <param name="HalfWidth">Half of the lane's width there, metres.</param>
/// <param name="Beyond">How far the place lies before the lane's start or past its end, metres; 0 beside it.</param>
/// <param name="IsPast">Whether the place lies past the lane's end.</param>
/// <param name="Height">How far it lies above the lane, metres.</param>
/// <param name="Along">Metres along the lane's middle, on the ground, from its start to the point that is nearest to the place.</param>
/// <param name="IsLeft">Whether the place lies to the left of the lane's middle.</param>
internal readonly record struct LanePiece(
    Vector2D Direction,
    double FromMiddle,
    double HalfWidth,
    double Beyond,
    bool IsPast,
    double Height,
    double Along,
    bool IsLeft
)
{
    /// <summary>Room for the rounding of places on an end or an edge, metres.</summary>
    private const double Rounding = 1e-6;

    /// <summary>Whether the place lies on the lane.</summary>
    public bool IsOnLane => Beyond <= Rounding && FromMiddle <= HalfWidth + Rounding;

    /// <summary>Distance from the lane on the ground, metres; 0 on it.</summary>
    public double FromLane
    {
        get
        {
            double aside = Math.Max(0, FromMiddle - HalfWidth);
            return Math.Sqrt((aside * aside) + (Beyond * Beyond));
        }
    }

    /// <summary>Where a place lies beside a lane.</summary>
    public static LanePiece NearestOf(MapLane lane, Vector3D place)
    {
        IReadOnlyList<Vector3D> middle = lane.Centre;
        LanePiece best = default;
        double least = double.PositiveInfinity;
        double travelled = 0;
        for (int i = 1; i < middle.Count; i++)
        {
            Vector3D piece = middle[i] - middle[i - 1];
            Vector3D to = place - middle[i - 1];
            var along = new Vector2D(piece.X, piece.Y);
            var apart = new Vector2D(to.X, to.Y);
            double square = along.Dot(along);
            double raw = square > 0 ? apart.Dot(along) / square : 0;
            double t = Math.Max(0, Math.Min(1, raw));
            double distance = (apart - (along * t)).Length;
            if (distance < least)
            {
                least = distance;
                bool isBeyond = (i == 1 && raw < 0) || (i == middle.Count - 1 && raw > 1);
                double half = (lane.StartWidth + ((lane.EndWidth - lane.StartWidth) * (i - 1 + t) / (middle.Count - 1))) / 2;
                best = new LanePiece(
                    along,
                    isBeyond && square > 0 ? Math.Abs(along.Cross(apart)) / along.Length : distance,
                    half,
                    isBeyond ? Math.Abs(raw - t) * along.Length : 0,
                    isBeyond && raw > 1,
                    to.Z - (piece.Z * t),
                    travelled + (t * along.Length),
                    along.Cross(apart) > 0
                );
            }

            travelled += along.Length;
        }

        return best;
    }
}
