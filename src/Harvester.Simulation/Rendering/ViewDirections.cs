using System.Numerics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The directions in the world that pixels look in, with a forward component of 1 m.</summary>
internal sealed class ViewDirections
{
    private readonly View _view;
    private readonly double _focalX;
    private readonly double _focalY;
    private readonly Vector3 _right;
    private readonly Vector3 _forward;
    private readonly Vector3 _up;
    private readonly Vector3[] _ofColumns = [];
    private readonly Vector3[] _ofRows = [];

    public ViewDirections(View view)
    {
        _view = view;
        RenderCamera camera = view.Camera;
        (_focalX, _focalY) = (camera.FocalX, camera.FocalY);
        Axes axes = camera.Pose.Axes;
        (_right, _forward, _up) = (Sky.ToSingle(axes.Right), Sky.ToSingle(axes.Forward), Sky.ToSingle(axes.Up));
        if (view.Grid is not null)
        {
            return;
        }

        _ofColumns = new Vector3[camera.Width];
        for (int column = 0; column < camera.Width; column++)
        {
            _ofColumns[column] = Across(column + 0.5);
        }

        _ofRows = new Vector3[camera.Height];
        for (int row = 0; row < camera.Height; row++)
        {
            _ofRows[row] = Down(row + 0.5);
        }
    }

    public Vector3 At(int column, int row)
    {
        if (_view.Grid is null)
        {
            return _ofColumns[column] - _ofRows[row];
        }

        Vector2D sample = _view.SampleAt(column, row);
        return Across(sample.X) - Down(sample.Y);
    }

    private Vector3 Across(double x) => _forward + (_right * (float)((x - _view.Camera.CentreX) / _focalX));

    private Vector3 Down(double y) => _up * (float)((y - _view.Camera.CentreY) / _focalY);
}
