using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Play.Screen;
using Harvester.Play.Screen.Windows;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Tests.Screen;

public sealed class GameWindowScreenTests : IDisposable
{
    private readonly ScriptedDesktop _desktop = new();
    private readonly GameWindowScreen _screen;
    private readonly PixelBuffer _buffer = new(new ImageSize(80, 60));

    public GameWindowScreenTests()
    {
        _screen = new GameWindowScreen(_desktop, ScriptedDesktop.Process);
    }

    public void Dispose() => _screen.Dispose();

    [Fact]
    public void Grab_at_negative_coordinates_copies_the_client_area()
    {
        Assert.True(_screen.Grab(_buffer).IsGood);

        // The scripted desktop's first byte is left + top = -50 + 20 = -30, modulo 256.
        Assert.Equal(226, _buffer.Bytes[0]);
    }

    [Fact]
    public void Grab_of_another_size_equals_the_scaled_window()
    {
        var small = new PixelBuffer(new ImageSize(20, 15));
        _screen.Grab(_buffer);

        Assert.True(_screen.Grab(small).IsGood);

        var expected = new PixelBuffer(small.Size);
        new ImageScaler(_buffer.Size, small.Size).Scale(_buffer, expected);
        Assert.Equal(expected.Bytes, small.Bytes);
    }

    [Fact]
    public void Grab_after_a_resize_is_refused_once()
    {
        Assert.True(_screen.Grab(_buffer).IsGood);
        _desktop.Client = new DesktopRectangle(0, 0, 90, 60);

        Assert.Equal(GrabRefusals.Resized, _screen.Grab(_buffer).Refusal);
        Assert.True(_screen.Grab(_buffer).IsGood);
    }

    [Fact]
    public void Grab_after_a_minimised_window_is_restored_succeeds()
    {
        Assert.True(_screen.Grab(_buffer).IsGood);
        _desktop.IsMinimised = true;
        Assert.Equal(GrabRefusals.Minimised, _screen.Grab(_buffer).Refusal);
        _desktop.IsMinimised = false;

        Assert.True(_screen.Grab(_buffer).IsGood);
    }

    [Fact]
    public void Grab_of_a_window_moved_between_grabs_succeeds()
    {
        Assert.True(_screen.Grab(_buffer).IsGood);
        _desktop.Client = new DesktopRectangle(0, 0, 80, 60);

        Assert.True(_screen.Grab(_buffer).IsGood);
        Assert.Equal(0, _buffer.Bytes[0]);
    }

    [Fact]
    public void Grab_of_a_window_that_changes_meanwhile_is_refused()
    {
        _desktop.DuringCopy = () =>
            _desktop.Client = _desktop.Client with { Left = _desktop.Client.Left + 1, Right = _desktop.Client.Right + 1 };
        Assert.Equal(GrabRefusals.Moved, _screen.Grab(_buffer).Refusal);

        _desktop.DuringCopy = () => _desktop.Client = _desktop.Client with { Right = _desktop.Client.Right + 1 };
        Assert.Equal(GrabRefusals.Resized, _screen.Grab(_buffer).Refusal);

        _desktop.DuringCopy = () => _desktop.IsMinimised = true;
        Assert.Equal(GrabRefusals.Resized, _screen.Grab(_buffer).Refusal);
        Assert.Equal(GrabRefusals.Minimised, _screen.Grab(_buffer).Refusal);
    }

    [Fact]
    public void Grab_of_a_desktop_that_cannot_be_read_is_refused()
    {
        _desktop.CanCopy = false;

        Assert.Equal(GrabRefusals.Unreadable, _screen.Grab(_buffer).Refusal);
    }

    [Fact]
    public void Grab_of_a_black_picture_is_refused()
    {
        _desktop.IsBlack = true;

        Assert.Equal(GrabRefusals.Black, _screen.Grab(_buffer).Refusal);
    }

    [Fact]
    public void Grab_of_another_process_finds_no_window()
    {
        using var other = new GameWindowScreen(_desktop, ScriptedDesktop.Process + 1);

        Assert.Equal(GrabResult.Refused(GrabRefusals.NoWindow), other.Grab(_buffer));
    }
}
