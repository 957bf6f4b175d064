using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Sessions.Text;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Features;

public sealed class CameraMountTests : IDisposable, ICameras, IVehicles
{
    private readonly string _folder = Directory.CreateTempSubdirectory("mount").FullName;
    private readonly PlayerMessages _messages;
    private double _shownDegrees;

    public CameraMountTests()
    {
        _messages = new PlayerMessages(_folder, static _ => { }, new TestClock());
    }

    public string? AttachingProblem => null;

    public int OfPlayer => 1;

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_folder, recursive: true);
    }

    [Fact]
    public void Usual_field_of_view_returns_after_another_mounting()
    {
        PlayerSettings settings = PlayerSettings.Read(IniFile.Read(new StringReader("[Camera]\nVerticalFov = 60\n")), _folder);
        var mount = new CameraMount(settings, _messages, this, this) { VerticalFovDegrees = 30 };
        mount.Mount();
        Assert.Equal(30, _shownDegrees);
        mount.MoveBack();

        Assert.Equal(60, _shownDegrees);
    }

    public int Make(Pose pose, double verticalFovDegrees)
    {
        _shownDegrees = verticalFovDegrees;
        return 1;
    }

    void ICameras.Attach(int camera, int vehicle, Pose mount) { }

    void ICameras.Zoom(int camera, double verticalFovDegrees) => _shownDegrees = verticalFovDegrees;

    void ICameras.Show(int camera) { }

    void ICameras.Remove(int camera) { }

    public bool Exists(int vehicle) => true;

    public int MakeBesidePlayer(int model, double metresBeside) => throw new NotSupportedException();

    void IVehicles.Prepare(int vehicle, int primaryColour, int secondaryColour, string plate) => throw new NotSupportedException();

    void IVehicles.Remove(int vehicle) => throw new NotSupportedException();
}
