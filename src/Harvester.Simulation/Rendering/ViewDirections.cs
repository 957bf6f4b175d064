using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The viewing directions of pixels in the world, with a forward component of 1 m.</summary>
internal sealed class ViewDirections
{
    private readonly View _view;
    private readonly Vector3 _right;
    private readonly Vector3 _forward;
    private readonly Vector3 _up;
    private readonly float[] _across = [];

    public ViewDirections(View view)
    {
        _view = view;
        Axes axes = view.Camera.Pose.Axes;
        (_right, _forward, _up) = (Sky.ToSingle(axes.Right), Sky.ToSingle(axes.Forward), Sky.ToSingle(axes.Up));
        if (view.Grid is not null)
        {
            return;
        }

        _across = new float[view.Camera.Width];
        for (int column = 0; column < _across.Length; column++)
        {
            _across[column] = Across(column + 0.5);
        }
    }

    /// <summary>Works out where the pixels of a row look.</summary>
    public void Begin(PixelRow row)
    {
        int width = _view.Camera.Width;
        if (_view.Grid is null)
        {
            _across.CopyTo(row.Across, 0);
            row.Down.AsSpan(0, width).Fill(Down(row.Number + 0.5));
        }
        else
        {
            for (int column = 0; column < width; column++)
            {
                Vector2D sample = _view.SampleAt(column, row.Number);
                row.Across[column] = Across(sample.X);
                row.Down[column] = Down(sample.Y);
            }
        }

        for (int column = 0; column < width; column += PixelRow.Step)
        {
            Vector256<float> across = Vector256.Create(row.Across, column);
            Vector256<float> down = Vector256.Create(row.Down, column);
            Vector256.Sqrt(Wide.One + (across * across) + (down * down)).CopyTo(row.Stretch, column);
        }
    }

    /// <summary>Where eight pixels look.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector At(PixelRow row, int column) =>
        WideVector.Of(_forward)
        + (WideVector.Of(_right) * Vector256.Create(row.Across, column))
        - (WideVector.Of(_up) * Vector256.Create(row.Down, column));

    private float Across(double x) => (float)((x - _view.Camera.CentreX) / _view.Camera.FocalX);

    private float Down(double y) => (float)((y - _view.Camera.CentreY) / _view.Camera.FocalY);
}
