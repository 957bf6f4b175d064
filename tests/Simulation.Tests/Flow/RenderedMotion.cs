using Harvester.Geometry;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Flow;

/// <summary>
/// Where the point of a mesh that one picture shows at the centre of a pixel is in another picture, by the renderer's own 4x4 matrices at
/// both times. The triangle of each pixel is found without clipping, by edge functions of homogeneous coordinates.
/// </summary>
internal sealed class RenderedMotion
{
    /// <summary>
    /// Within the image, the lens of these tests scales by 1 - 0.12 r² + 0.03 r⁴ with r up to 0.8, which is at least 0.93.
    /// </summary>
    private const double MinLensFactor = 0.9;

    private readonly RenderCamera _from;
    private readonly RenderCamera _to;
    private readonly SampleGrid? _grid;
    private readonly double[] _depths;
    private readonly MeshInstance?[] _instances;
    private readonly Vector3D[] _points;
    private readonly Dictionary<int, Pose> _moved = [];
    private readonly SceneRayCaster _rays;

    public RenderedMotion(Moment from, Moment to, RenderScene world, Func<Moment, RenderCamera> cameraOf)
    {
        (_from, _to) = (cameraOf(from), cameraOf(to));
        _grid = _from.Lens.IsRectilinear ? null : new SampleGrid(_from);
        int pixels = _from.Width * _from.Height;
        (_depths, _instances, _points) = (new double[pixels], new MeshInstance?[pixels], new Vector3D[pixels]);
        Array.Fill(_depths, double.PositiveInfinity);
        foreach (MeshInstance instance in to.Moving)
        {
            _moved.TryAdd(instance.Handle, instance.Pose);
        }

        _rays = new SceneRayCaster(to.SceneIn(world));
        foreach (MeshInstance instance in world.Static.Instances)
        {
            Draw(instance);
        }

        foreach (MeshInstance instance in from.Moving)
        {
            Draw(instance);
        }

        HashSet<int> moving = [.. from.Moving.Select(instance => instance.Handle)];
        StandsStill = handle => !moving.Contains(handle);
    }

    /// <summary>Whether an entity is part of the static world.</summary>
    private Func<int, bool> StandsStill { get; }

    /// <summary>The handle of what a pixel shows; null for the sky.</summary>
    public int? HandleAt(int pixel) => _instances[pixel]?.Handle;

    /// <summary>The depth of what a pixel shows; infinite for the sky.</summary>
    public double DepthAt(int pixel) => _depths[pixel];

    /// <summary>Where the point is at the other time, world; null if its mesh is not there, or for the sky.</summary>
    public Vector3D? MovedAt(int pixel) =>
        _instances[pixel] is not { } instance ? null
        : StandsStill(instance.Handle) ? InWorld(instance.Pose, _points[pixel])
        : _moved.TryGetValue(instance.Handle, out Pose pose) ? InWorld(pose, _points[pixel])
        : null;

    /// <summary>Where the point is in the other picture, pixels; null behind its near plane.</summary>
    public (double U, double V)? PixelOf(Vector3D moved)
    {
        Vector4 clip = _to.ViewProjection.Transform(moved);
        if (clip.W < _to.NearClip)
        {
            return null;
        }

        // The lens scales normalised coordinates by 1 + k1 r² + k2 r⁴.
        (double x, double y) = (((clip.X / clip.W) - _to.CentreX) / _to.FocalX, ((clip.Y / clip.W) - _to.CentreY) / _to.FocalY);
        double square = (x * x) + (y * y);
        double bend = 1 + (square * (_to.Lens.K1 + (square * _to.Lens.K2)));
        return (_to.CentreX + (_to.FocalX * x * bend), _to.CentreY + (_to.FocalY * y * bend));
    }

    /// <summary>Whether nothing lies between the other camera and a point, up to a distance in front of the point, metres.</summary>
    public bool IsVisible(Vector3D moved, double slackMetres)
    {
        Vector3D sight = moved - _to.Pose.Position;
        return _rays.Cast(new Ray(_to.Pose.Position, sight.Normalized()), sight.Length - slackMetres, 0) is null;
    }

    private static Vector3D InWorld(Pose pose, Vector3D point)
    {
        Vector4 world = Matrix4.ToWorld(pose).Transform(point);
        return new Vector3D(world.X, world.Y, world.Z);
    }

    private void Draw(MeshInstance instance)
    {
        Matrix4 toClip = _from.ViewProjection * Matrix4.ToWorld(instance.Pose);
        foreach (ref readonly MeshTriangle triangle in instance.Mesh.Triangles)
        {
            Draw(instance, triangle, At(toClip, triangle.A), At(toClip, triangle.B), At(toClip, triangle.C));
        }
    }

    private static Vector3D At(in Matrix4 toClip, Vector3D point)
    {
        Vector4 clip = toClip.Transform(point);
        return new Vector3D(clip.X, clip.Y, clip.W);
    }

    private void Draw(MeshInstance instance, in MeshTriangle triangle, Vector3D a, Vector3D b, Vector3D c)
    {
        if (Math.Max(a.Z, Math.Max(b.Z, c.Z)) < _from.NearClip)
        {
            return;
        }

        // With a = (x w, y w, w) of a corner and p = (x, y, 1), the weights e of p = e1 a + e2 b + e3 c are (b × c) · p / det and so on.
        // They add up to 1 / w, and divided by that they are the weights of the corners in space.
        Vector3D bc = b.Cross(c);
        double determinant = a.Dot(bc);
        if (determinant == 0)
        {
            return;
        }

        (Vector3D ea, Vector3D eb, Vector3D ec) = (bc / determinant, c.Cross(a) / determinant, a.Cross(b) / determinant);
        (int left, int top, int right, int bottom) = BoundsOf(a, b, c);
        for (int row = top; row < bottom; row++)
        {
            for (int column = left; column < right; column++)
            {
                int at = (row * _from.Width) + column;
                var p = _grid is null ? new Vector3D(column + 0.5, row + 0.5, 1) : new Vector3D(_grid.U[at], _grid.V[at], 1);
                (double wa, double wb, double wc) = (ea.Dot(p), eb.Dot(p), ec.Dot(p));
                double inverse = wa + wb + wc;
                if (wa < 0 || wb < 0 || wc < 0 || !(inverse > 0) || 1 / inverse < _from.NearClip || 1 / inverse >= _depths[at])
                {
                    continue;
                }

                _depths[at] = 1 / inverse;
                _instances[at] = instance;
                _points[at] = ((triangle.A * wa) + (triangle.B * wb) + (triangle.C * wc)) / inverse;
            }
        }
    }

    private (int Left, int Top, int Right, int Bottom) BoundsOf(Vector3D a, Vector3D b, Vector3D c)
    {
        if (Math.Min(a.Z, Math.Min(b.Z, c.Z)) < _from.NearClip)
        {
            return (0, 0, _from.Width, _from.Height);
        }

        (int left, int right) = Range(a.X / a.Z, b.X / b.Z, c.X / c.Z, _from.CentreX, _from.Width);
        (int top, int bottom) = Range(a.Y / a.Z, b.Y / b.Z, c.Y / c.Z, _from.CentreY, _from.Height);
        return (left, top, right, bottom);
    }

    /// <summary>The pixels that three coordinates may span along one axis, whichever of the lens's factors applies.</summary>
    private (int First, int End) Range(double a, double b, double c, double centre, int size)
    {
        double least = Math.Min(a, Math.Min(b, c)) - centre;
        double greatest = Math.Max(a, Math.Max(b, c)) - centre;
        double factor = _grid is null ? 1 : MinLensFactor;
        double first = centre + Math.Min(least, least * factor) - 1;
        double end = centre + Math.Max(greatest, greatest * factor) + 1;
        return ((int)Math.Clamp(first, 0, size), (int)Math.Clamp(end, 0, size));
    }
}
