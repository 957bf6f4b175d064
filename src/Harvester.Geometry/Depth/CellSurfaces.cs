namespace Harvester.Geometry.Depth;

/// <summary>
/// The surfaces that the samples at the corners of a cell show in one region of the mask, and the depth that they give at its places.
/// </summary>
internal sealed class CellSurfaces
{
    /// <summary>Samples whose planes predict each other to this fraction of the depth are taken to be of one surface.</summary>
    private const double SmoothResidual = 0.05;

    /// <summary>Planes that meet in an edge predict the depths of the corners to this fraction.</summary>
    private const double EdgeTolerance = 0.002;

    /// <summary>
    /// A plane that would give more than this multiple of its sample's depth, or less than its inverse, is not extended: seen at a grazing
    /// angle, small errors of its normal grow without bound.
    /// </summary>
    private const double MaxExtension = 3;

    private readonly Corner[] _corners = new Corner[4];
    private DepthCell _cell;
    private int _count;
    private double _residual;
    private bool _isOneEntity;
    private bool _hasMiss;
    private Edge _edge;

    /// <summary>How the surfaces meet.</summary>
    private enum Edge
    {
        /// <summary>Unknown: each place shows what the nearest corner shows.</summary>
        Unknown,

        /// <summary>All corners show one surface.</summary>
        None,

        /// <summary>Each place shows the nearest plane, as where a wall stands on the ground.</summary>
        Inner,

        /// <summary>Each place shows the farthest plane, as at the corner of a house.</summary>
        Outer,
    }

    /// <summary>Discards the corners of the cell before.</summary>
    public void Begin(DepthCell cell) => (_cell, _count, _residual, _isOneEntity, _hasMiss) = (cell, 0, 0, true, false);

    /// <summary>Adds a corner of the region.</summary>
    /// <param name="number">Its place in <see cref="DepthCell.Corners"/>.</param>
    /// <param name="place">The number of its place in the grid.</param>
    /// <param name="sample">Its sample.</param>
    /// <param name="residual">How far neighbouring planes fail to predict it, as a fraction.</param>
    /// <param name="line">Its line of sight.</param>
    public void Add(int number, int place, DepthSample sample, double residual, SightLine line)
    {
        _corners[_count++] = new Corner(number, place, sample, line);
        _residual = Math.Max(_residual, residual);
        _isOneEntity &= sample.Entity == _corners[0].Sample.Entity;
        _hasMiss |= !sample.IsHit;
    }

    /// <summary>Finds out how the surfaces of the corners meet.</summary>
    public void Understand()
    {
        _edge = _residual <= SmoothResidual ? Edge.None : Edge.Unknown;
        bool isInner = true;
        bool isOuter = true;
        double deviation = 0;
        for (int i = 0; i < _count; i++)
        {
            (double nearest, double farthest) = (0, double.PositiveInfinity);
            for (int j = 0; j < _count; j++)
            {
                if (!_corners[i].Sample.IsHit || !_corners[j].Sample.IsHit)
                {
                    return;
                }

                // Depth of sample i divided by the depth at which plane j would be seen there: above 1, plane j lies in front of the
                // sample; below 1, behind it.
                double relative = _corners[j].Sample.Surface.InverseAt(_corners[i].Line) * _corners[i].Sample.Depth;
                (nearest, farthest) = (Math.Max(nearest, relative), Math.Min(farthest, relative));
            }

            // If no plane is in front of any sample, each shows the nearest plane; if none is behind, the farthest. If both hold, all
            // planes agree.
            isInner &= nearest < 1 + EdgeTolerance;
            isOuter &= farthest > 1 - EdgeTolerance;
            deviation = Math.Max(deviation, Math.Max(nearest - 1, 1 - farthest));
        }

        _edge =
            deviation <= EdgeTolerance ? Edge.None
            : isInner ? Edge.Inner
            : isOuter ? Edge.Outer
            : _edge;
    }

    /// <summary>Whether the surfaces of the corners meet in an edge.</summary>
    public bool MeetInEdge => _edge is Edge.Inner or Edge.Outer;

    /// <summary>The depth at a place of the cell; null if no corner is of its region.</summary>
    public (double Depth, double Error, int Source)? DepthAt(int column, int row, SightLine line)
    {
        if (_count == 0)
        {
            return null;
        }

        double right = _cell.Right > _cell.Left ? (column - _cell.Left) / (double)(_cell.Right - _cell.Left) : 0;
        double down = _cell.Bottom > _cell.Top ? (row - _cell.Top) / (double)(_cell.Bottom - _cell.Top) : 0;
        int nearest = 0;
        double heaviest = -1;
        double sum = 0;
        double weights = 0;
        (double least, double greatest) = (double.PositiveInfinity, 0);
        for (int i = 0; i < _count; i++)
        {
            // Bilinear weights. Inverse depth is linear in the image along a plane (1 / depth = normal · direction), so it is what is
            // averaged.
            int number = _corners[i].Number;
            double weight = ((number & 1) == 0 ? 1 - right : right) * (number < 2 ? 1 - down : down);
            (nearest, heaviest) = weight > heaviest ? (i, weight) : (nearest, heaviest);
            if (_corners[i].Sample.IsHit)
            {
                double inverse = InverseOf(_corners[i].Sample, line);
                (sum, weights) = (sum + (weight * inverse), weights + weight);
                (least, greatest) = (Math.Min(least, inverse), Math.Max(greatest, inverse));
            }
        }

        Corner near = _corners[nearest];
        if (!near.Sample.IsHit)
        {
            return (double.PositiveInfinity, 0, near.Place);
        }

        double own = InverseOf(near.Sample, line);
        double chosen = _edge switch
        {
            Edge.None when weights > 0 && _isOneEntity => sum / weights,
            Edge.Inner => greatest,
            Edge.Outer => least,
            _ => own,
        };

        // The error is the spread of what the surfaces could give here, and at least what neighbouring planes failed to predict. Next to a
        // place without a hit nothing is certain: the whole depth.
        double depth = 1 / chosen;
        double error = Math.Max(Math.Max(Math.Abs((1 / least) - depth), Math.Abs((1 / greatest) - depth)), _residual * depth);
        return (depth, _hasMiss ? Math.Max(error, depth) : error, SourceOf(chosen, line, nearest));
    }

    /// <summary>The inverse depth at which a sample's surface is seen.</summary>
    public static double InverseOf(DepthSample sample, SightLine line)
    {
        double inverse = sample.Surface.InverseAt(line);
        double own = 1 / sample.Depth;
        return inverse >= own / MaxExtension && inverse <= own * MaxExtension ? inverse : own;
    }

    private int SourceOf(double chosen, SightLine line, int nearest)
    {
        if (_edge is not (Edge.Inner or Edge.Outer))
        {
            return _corners[nearest].Place;
        }

        for (int i = 0; i < _count; i++)
        {
            if (InverseOf(_corners[i].Sample, line).Equals(chosen))
            {
                return _corners[i].Place;
            }
        }

        return _corners[nearest].Place;
    }

    /// <summary>A sampled corner of the cell.</summary>
    private readonly record struct Corner(int Number, int Place, DepthSample Sample, SightLine Line);
}
