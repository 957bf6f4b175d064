using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Motion;

/// <summary>
/// Makes the flow from one picture to another: each pixel's point, from its depth, moves with the body that it belongs to and is projected
/// into the other camera.
/// </summary>
public sealed class FlowMaker
{
    /// <summary>Flows of at least so many pixels along an axis cannot be written: KITTI's numbers end at 512.</summary>
    public const double MaxPixels = 511.98;

    /// <summary>
    /// A point is hidden if the surface in its place is nearer by this fraction of the depth: depth maps are samples at the centres of
    /// pixels, and surfaces seen at a slant change by about as much within a pixel.
    /// </summary>
    public const double CoveredFraction = 0.01;

    private readonly SurfaceMap _from;
    private readonly SurfaceMap _to;
    private readonly Func<int, BodyMotion> _motionOf;
    private readonly Dictionary<int, PixelTransform> _transforms = [];
    private readonly CameraIntrinsics _lens;
    private readonly Camera _camera;
    private readonly bool _isRectilinear;
    private readonly int _width;
    private readonly int _height;
    private readonly float[] _metres;
    private readonly float[] _u;
    private readonly float[] _v;
    private readonly float[]? _motion;

    /// <summary>Prepares a flow; rows are made by <see cref="MakeRows"/>.</summary>
    /// <param name="from">The picture whose pixels get a flow.</param>
    /// <param name="to">The other picture; of the same size.</param>
    /// <param name="motionOf">The motion of an entity by its handle; 0 is the static world.</param>
    /// <param name="hasMotion">Whether <see cref="FlowField.Motion"/> is made too.</param>
    /// <exception cref="ArgumentException">The pictures have different sizes.</exception>
    public FlowMaker(SurfaceMap from, SurfaceMap to, Func<int, BodyMotion> motionOf, bool hasMotion)
    {
        _from = Guard.NotNull(from, nameof(from));
        _to = Guard.NotNull(to, nameof(to));
        _motionOf = Guard.NotNull(motionOf, nameof(motionOf));
        if (from.Camera.Image != to.Camera.Image)
        {
            throw new ArgumentException("The two pictures must have one size.", nameof(to));
        }

        (_camera, _lens, _isRectilinear) = (to.Camera, to.Camera.Intrinsics, to.Camera.Intrinsics.Lens.IsRectilinear);
        int pixels = from.Camera.Image.PixelCount;
        Field = new FlowField(from.Camera.Image)
        {
            ErrorPixels = from.ErrorMetres is null ? null : new float[pixels],
            Motion = hasMotion ? new float[3 * pixels] : null,
        };
        (_width, _height, _metres) = (from.Camera.Image.Width, from.Camera.Image.Height, from.Metres);
        (_u, _v, _motion) = (Field.U, Field.V, Field.Motion);
    }

    /// <summary>The flow, of the rows that were made.</summary>
    public FlowField Field { get; }

    /// <summary>Makes all rows.</summary>
    public FlowField Make()
    {
        MakeRows(0, Field.Image.Height);
        return Field;
    }

    /// <summary>Makes rows from a number up to another one, which is not included.</summary>
    public void MakeRows(int top, int bottom)
    {
        int[] entities = _from.Entities;
        byte[] flags = Field.Flags;
        int entity = 0;
        PixelTransform transform = TransformOf(0);
        for (int row = top; row < bottom; row++)
        {
            for (int column = 0; column < _width; column++)
            {
                int at = (row * _width) + column;
                if (entities[at] != entity)
                {
                    entity = entities[at];
                    transform = TransformOf(entity);
                }

                flags[at] = (byte)Make(at, column, row, entity, transform);
            }
        }
    }

    private FlowFlags Make(int at, int column, int row, int entity, PixelTransform transform)
    {
        double depth = _metres[at];
        if (transform.Kind is BodyMotionKind.Person or BodyMotionKind.Unknown || double.IsNaN(depth))
        {
            SetMotion(at, double.NaN, double.NaN, double.NaN);
            return transform.Kind == BodyMotionKind.Person ? FlowFlags.Person : FlowFlags.Unknown;
        }

        (double right, double up) = (_from.Lines.RightOf(column, row), _from.Lines.UpOf(column, row));
        Vector3D line = transform.Direction(right, up);
        bool isInfinite = double.IsPositiveInfinity(depth);
        FlowFlags flags = isInfinite ? FlowFlags.Infinite : FlowFlags.None;
        if (isInfinite)
        {
            SetMotion(at, double.NaN, double.NaN, double.NaN);
        }
        else if (transform.Kind == BodyMotionKind.Static)
        {
            SetMotion(at, 0, 0, 0);
        }
        else
        {
            // The motion that has led from the other moment to this one is the opposite of the one that leads there.
            Vector3D moved = transform.Displacement(right, up, depth);
            flags |= PixelTransform.IsMotion(moved) ? FlowFlags.Moved : FlowFlags.None;
            SetMotion(at, -moved.X, moved.Z, -moved.Y);
        }

        // The point d · R l + t of the other camera's frame; at infinity only the direction R l remains.
        Vector3D point = isInfinite ? line : (line * depth) + transform.Translation;
        if (!(point.Y > 0) || (!isInfinite && point.Y < _lens.NearClip))
        {
            return flags | FlowFlags.LeavesPicture;
        }

        (double u, double v) = PixelOf(point);
        (double flowU, double flowV) = (u - column - 0.5, v - row - 0.5);
        if (!(Math.Abs(flowU) <= MaxPixels && Math.Abs(flowV) <= MaxPixels))
        {
            return flags | FlowFlags.LeavesPicture;
        }

        (_u[at], _v[at]) = ((float)flowU, (float)flowV);
        double error = 0;
        if (Field.ErrorPixels is { } errorPixels)
        {
            error = isInfinite ? 0 : _from.ErrorMetres![at];
            errorPixels[at] = (float)ErrorOf(line, transform.Translation, depth, error, u, v);
        }

        flags |= FlowFlags.Valid;
        return !(u >= 0 && v >= 0 && u < _width && v < _height) ? flags | FlowFlags.LeavesPicture
            : IsCovered(u, v, isInfinite ? double.PositiveInfinity : point.Y, entity, error) ? flags | FlowFlags.Covered
            : flags;
    }

    /// <summary>How far the flow changes if the depth is wrong by its error, to either side, pixels.</summary>
    private double ErrorOf(Vector3D line, Vector3D translation, double depth, double error, double u, double v)
    {
        if (error <= 0)
        {
            return 0;
        }

        // The images of the points of a line of sight lie on a line, on which the inverse depth is about linear. An error of the whole
        // depth or more says that the pixel may show what is behind the surface, up to infinity; towards the camera it then counts in
        // inverse depth. A point that the error brings behind the other camera may be anywhere.
        bool isBounded = error < depth;
        Vector3D nearer = (line * (isBounded ? depth - error : depth * depth / (depth + error))) + translation;
        Vector3D farther = isBounded ? (line * (depth + error)) + translation : line;
        if (nearer.Y < _lens.NearClip || farther.Y < _lens.NearClip)
        {
            return MaxPixels;
        }

        (double nearU, double nearV) = PixelOf(nearer);
        (double farU, double farV) = PixelOf(farther);
        double toNear = new Vector2D(nearU - u, nearV - v).Length;
        double toFar = new Vector2D(farU - u, farV - v).Length;
        return Math.Min(MaxPixels, Math.Max(toNear, toFar));
    }

    private (double U, double V) PixelOf(Vector3D point)
    {
        if (!_isRectilinear)
        {
            Vector2D pixel = _camera.PixelOf(point);
            return (pixel.X, pixel.Y);
        }

        double inverse = 1 / point.Y;
        return (_lens.Cx + (_lens.Fx * point.X * inverse), _lens.Cy - (_lens.Fy * point.Z * inverse));
    }

    /// <summary>Whether the other picture shows, at a place, a surface in front of a point.</summary>
    private bool IsCovered(double u, double v, double depth, int entity, double error)
    {
        (int column, int row) = ((int)u, (int)v);
        int at = (row * _width) + column;
        double limit = (depth * (1 - CoveredFraction)) - error;
        if (!IsNearer(at, limit))
        {
            return false;
        }

        if (_to.Entities[at] != entity)
        {
            return true;
        }

        // Within one surface the place lies among the centres of four pixels. If it is the point's own surface, seen at a slant, one of
        // them is not nearer than the point.
        int across = u - column < 0.5 ? (column > 0 ? -1 : 0) : (column < _width - 1 ? 1 : 0);
        int down = (v - row < 0.5 ? (row > 0 ? -1 : 0) : (row < _height - 1 ? 1 : 0)) * _width;
        return IsNearer(at + across, limit) && IsNearer(at + down, limit) && IsNearer(at + across + down, limit);
    }

    private bool IsNearer(int at, double limit) => _to.Metres[at] + (_to.ErrorMetres?[at] ?? 0) < limit;

    private void SetMotion(int at, double right, double down, double forward)
    {
        if (_motion is not null)
        {
            (_motion[3 * at], _motion[(3 * at) + 1], _motion[(3 * at) + 2]) = ((float)right, (float)down, (float)forward);
        }
    }

    private PixelTransform TransformOf(int entity)
    {
        if (!_transforms.TryGetValue(entity, out PixelTransform? transform))
        {
            BodyMotion motion = entity == 0 ? BodyMotion.Static : _motionOf(entity);
            _transforms[entity] = transform = new PixelTransform(_from.Camera, _to.Camera, motion);
        }

        return transform;
    }
}
