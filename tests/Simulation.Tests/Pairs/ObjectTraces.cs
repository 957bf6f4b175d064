using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Pairs;

/// <summary>
/// Where a picture may show objects: their own pixels by the handles that the renderer wrote; their shadows, where a ray from the place
/// that a pixel shows towards the sun or the zenith meets their boxes; and their reflections, where the mirrored line of sight does, and
/// where it leads to one of their shadows. Reflections are taken from the picture, so those of what objects hide may change as well. Places
/// come from the depths that the renderer wrote.
/// </summary>
internal sealed class ObjectTraces
{
    /// <summary>A border smooths the pixels on both of its sides.</summary>
    private const int SmoothedPixels = 1;

    /// <summary>
    /// Shadow maps have texels of 0.125 m near the camera and 0.8 m beyond 108 m, and are read with a bias and four neighbours.
    /// </summary>
    private const double NearShadowMetres = 0.6;
    private const double FarShadowMetres = 3;
    private const double FarMetres = 90;

    /// <summary>The sky is looked for 0.75 m in front of a surface, in texels of 0.25 m spread by one and tapped one further.</summary>
    private const double ContactMetres = 1.5;

    /// <summary>Reflections are found in steps of three rows, for blocks of two pixels.</summary>
    private const double ReflectionPixels = 6;
    private const double ReflectionMetres = 0.3;
    private const int ReflectionBlock = 2;

    private readonly CameraState _camera;
    private readonly RenderTarget _drawn;
    private readonly EntityState[] _objects;

    /// <param name="scene">The scene.</param>
    /// <param name="drawn">What the renderer drew with all objects.</param>
    /// <param name="handles">The objects.</param>
    /// <param name="lighting">The light of the picture; only in rain does the ground mirror anything.</param>
    /// <param name="detail">Only pictures of full detail have shadows and reflections.</param>
    public ObjectTraces(SceneSnapshot scene, RenderTarget drawn, IReadOnlyCollection<int> handles, Lighting lighting, Detail detail)
    {
        (_camera, _drawn) = (scene.Camera, drawn);
        _objects = [.. scene.Entities.Where(entity => handles.Contains(entity.Handle))];
        Object = [.. drawn.Handles.Select(handles.Contains)];
        bool[] shaded =
        [
            .. Enumerable.Range(0, Object.Length).Select(pixel => detail == Detail.Full && IsShaded(pixel, lighting.SunDirection)),
        ];
        bool isMirrored = detail == Detail.Full && lighting.RainFraction > 0;
        bool[] traces =
        [
            .. Enumerable
                .Range(0, Object.Length)
                .Select(pixel =>
                    Object[pixel] || shaded[pixel] || (isMirrored && (IsMirroring(pixel) || MirrorsWhatObjectsChange(pixel, shaded)))
                ),
        ];
        Allowed = Widened(traces);
    }

    /// <summary>The pixels whose centres show one of the objects.</summary>
    public bool[] Object { get; }

    /// <summary>The pixels that may change when the objects are hidden.</summary>
    public bool[] Allowed { get; }

    private bool IsShaded(int pixel, Vector3D sun)
    {
        if (float.IsPositiveInfinity(_drawn.Depth[pixel]))
        {
            return false;
        }

        Vector3D place = PlaceAt(pixel);
        double margin = _drawn.Depth[pixel] > FarMetres ? FarShadowMetres : NearShadowMetres;
        return _objects.Any(entity => IsMet(entity, place, sun, margin) || IsMet(entity, place, new Vector3D(0, 0, 1), ContactMetres));
    }

    private bool IsMirroring(int pixel)
    {
        if (float.IsPositiveInfinity(_drawn.Depth[pixel]))
        {
            return false;
        }

        Vector3D place = PlaceAt(pixel);
        Vector3D sight = (place - _camera.Pose.Position).Normalized();
        double focal = _drawn.Height / 2.0 / Math.Tan(_camera.VerticalFovDegrees * Math.PI / 360);
        return _objects.Any(entity =>
            IsMet(
                entity,
                place,
                sight with
                {
                    Z = Math.Abs(sight.Z),
                },
                ReflectionMetres + (ReflectionPixels / focal * (entity.Pose.Position - _camera.Pose.Position).Length)
            )
        );
    }

    /// <summary>
    /// Whether an object in the columns above hides what the ground at a pixel would mirror, or a shadow there is mirrored in it.
    /// </summary>
    private bool MirrorsWhatObjectsChange(int pixel, bool[] shaded)
    {
        int row = pixel / _drawn.Width;
        int column = pixel % _drawn.Width;
        double ground = PlaceAt(pixel).Z;
        for (int x = Math.Max(0, column - ReflectionBlock); x <= Math.Min(_drawn.Width - 1, column + ReflectionBlock); x++)
        {
            for (int y = 0; y < row; y++)
            {
                int other = (y * _drawn.Width) + x;
                if (Object[other] && _drawn.Depth[other] < _drawn.Depth[pixel])
                {
                    return true;
                }

                if (
                    shaded[other]
                    && PlaceAt(other) is var place
                    && Math.Abs(RowOf(place with { Z = (2 * ground) - place.Z }) - (row + 0.5)) < ReflectionPixels
                )
                {
                    return true;
                }
            }
        }

        return false;
    }

    private double RowOf(Vector3D place)
    {
        Vector3D away = place - _camera.Pose.Position;
        Axes axes = _camera.Pose.Axes;
        double tangent = Math.Tan(_camera.VerticalFovDegrees * Math.PI / 360);
        return (1 - (away.Dot(axes.Up) / away.Dot(axes.Forward) / tangent)) * _drawn.Height / 2;
    }

    /// <summary>The place in the world that the centre of a pixel shows.</summary>
    private Vector3D PlaceAt(int pixel)
    {
        double tangent = Math.Tan(_camera.VerticalFovDegrees * Math.PI / 360);
        double right = ((((pixel % _drawn.Width) + 0.5) / _drawn.Width * 2) - 1) * tangent * _camera.WindowAspect;
        double up = (1 - (((pixel / _drawn.Width) + 0.5) / _drawn.Height * 2)) * tangent;
        Axes axes = _camera.Pose.Axes;
        return _camera.Pose.Position + ((axes.Forward + (axes.Right * right) + (axes.Up * up)) * _drawn.Depth[pixel]);
    }

    /// <summary>Whether a ray meets the box of an entity, made larger on all sides, by the method of slabs.</summary>
    private static bool IsMet(EntityState entity, Vector3D from, Vector3D direction, double margin)
    {
        Axes axes = entity.Pose.Axes;
        Vector3D away = from - entity.Pose.Position;
        double enter = 0,
            leave = double.PositiveInfinity;
        foreach (
            (Vector3D axis, double min, double max) in new[]
            {
                (axes.Right, entity.ModelMin.X, entity.ModelMax.X),
                (axes.Forward, entity.ModelMin.Y, entity.ModelMax.Y),
                (axes.Up, entity.ModelMin.Z, entity.ModelMax.Z),
            }
        )
        {
            double at = away.Dot(axis),
                speed = direction.Dot(axis);
            double first = (min - margin - at) / speed,
                second = (max + margin - at) / speed;
            if (speed == 0 && (at < min - margin || at > max + margin))
            {
                return false;
            }

            (enter, leave) =
                speed == 0 ? (enter, leave) : (Math.Max(enter, Math.Min(first, second)), Math.Min(leave, Math.Max(first, second)));
        }

        return enter <= leave;
    }

    private bool[] Widened(bool[] pixels)
    {
        bool[] widened = new bool[pixels.Length];
        for (int pixel = 0; pixel < pixels.Length; pixel++)
        {
            for (int row = -SmoothedPixels; pixels[pixel] && row <= SmoothedPixels; row++)
            {
                for (int column = -SmoothedPixels; column <= SmoothedPixels; column++)
                {
                    int x = (pixel % _drawn.Width) + column;
                    int y = (pixel / _drawn.Width) + row;
                    if (x >= 0 && x < _drawn.Width && y >= 0 && y < _drawn.Height)
                    {
                        widened[(y * _drawn.Width) + x] = true;
                    }
                }
            }
        }

        return widened;
    }
}
