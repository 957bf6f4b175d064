using Harvester.Play.Screen;

namespace Harvester.Play.Tests.Screen;

public sealed class WindowJudgeTests
{
    private const int Game = 7;
    private const int Other = 8;
    private static readonly DesktopRectangle Client = new(100, 100, 500, 400);
    private static readonly DesktopRectangle Monitor = new(0, 0, 1920, 1080);

    [Fact]
    public void Judge_a_window_in_the_open_gives_its_client_area()
    {
        WindowVerdict verdict = Judge([GameWindow()]);

        Assert.Null(verdict.Refusal);
        Assert.Equal(Client, verdict.Client);
        Assert.Equal(1, verdict.Window);
    }

    [Fact]
    public void Judge_without_a_window_of_the_process_refuses() =>
        Assert.Equal(GrabRefusals.NoWindow, Judge([GameWindow() with { ProcessId = Other }]).Refusal);

    [Fact]
    public void Judge_a_minimised_window_refuses() =>
        Assert.Equal(GrabRefusals.Minimised, Judge([GameWindow() with { IsMinimised = true, Client = default }]).Refusal);

    [Fact]
    public void Judge_a_cloaked_game_refuses() =>
        Assert.Equal(GrabRefusals.NoWindow, Judge([GameWindow() with { ShowsNothing = true }]).Refusal);

    [Fact]
    public void Judge_a_window_without_client_area_refuses() =>
        Assert.Equal(GrabRefusals.NoWindow, Judge([GameWindow() with { Client = new(100, 100, 500, 100) }]).Refusal);

    [Theory]
    [InlineData(499, 399, 600, 500, GrabRefusals.Covered)]
    [InlineData(0, 0, 101, 101, GrabRefusals.Covered)]
    [InlineData(0, 0, 1920, 1080, GrabRefusals.Covered)]
    [InlineData(500, 100, 600, 400, null)]
    [InlineData(100, 400, 500, 500, null)]
    [InlineData(0, 0, 100, 1080, null)]
    [InlineData(300, 300, 300, 350, null)]
    public void Judge_counts_every_covered_pixel_and_no_touching_edge(int left, int top, int right, int bottom, string? refusal) =>
        Assert.Equal(refusal, Judge([Window(2, Other, new(left, top, right, bottom)), GameWindow()]).Refusal);

    [Fact]
    public void Judge_considers_only_visible_windows_above()
    {
        TopLevelWindow over = Window(2, Other, Client);

        Assert.Null(Judge([over with { ShowsNothing = true }, GameWindow()]).Refusal);
        Assert.Null(Judge([over with { IsMinimised = true }, GameWindow()]).Refusal);
        Assert.Null(Judge([GameWindow(), over]).Refusal);
        Assert.Equal(GrabRefusals.Covered, Judge([over with { ProcessId = Game, IsApplication = false }, GameWindow()]).Refusal);
    }

    [Theory]
    [InlineData(-1, 0, 399, 300)]
    [InlineData(0, -1, 400, 299)]
    [InlineData(1521, 0, 1921, 300)]
    [InlineData(0, 781, 400, 1081)]
    [InlineData(-3000, 0, -2600, 300)]
    public void Judge_a_window_beyond_the_monitor_refuses(int left, int top, int right, int bottom) =>
        Assert.Equal(GrabRefusals.OffScreen, Judge([GameWindow() with { Client = new(left, top, right, bottom) }]).Refusal);

    [Fact]
    public void Judge_accepts_a_window_on_a_monitor_left_of_and_above() =>
        Assert.Null(Judge([GameWindow() with { Client = new(-2560, -700, -1, -1) }], Monitor, new(-2560, -1440, 0, 0)).Refusal);

    [Fact]
    public void Judge_accepts_a_window_across_monitors_that_leave_no_gap()
    {
        TopLevelWindow across = GameWindow() with { Client = new(-200, 50, 300, 350) };

        Assert.Null(Judge([across], Monitor, new(-1280, 0, 0, 1024)).Refusal);
        Assert.Equal(GrabRefusals.OffScreen, Judge([across], Monitor, new(-1280, 100, 0, 1024)).Refusal);
        Assert.Equal(GrabRefusals.OffScreen, Judge([across], Monitor, new(-1280, 0, -1, 1024)).Refusal);
        Assert.Null(Judge([across], new(-1280, 0, 0, 200), Monitor, new(-1280, 200, 0, 1024)).Refusal);
    }

    [Fact]
    public void Judge_without_monitors_refuses() =>
        Assert.Equal(GrabRefusals.OffScreen, WindowJudge.Judge(new DesktopView([GameWindow()], []), Game, 0).Refusal);

    [Fact]
    public void Judge_takes_the_largest_application_window_of_the_process()
    {
        TopLevelWindow small = Window(2, Game, new(0, 0, 50, 50));
        TopLevelWindow tool = Window(3, Game, new(600, 0, 1900, 1000)) with { IsApplication = false };

        Assert.Equal(1, Judge([tool, small, GameWindow()]).Window);
    }

    [Fact]
    public void Judge_recognises_a_minimised_game()
    {
        TopLevelWindow small = Window(2, Game, new(0, 0, 50, 50));
        TopLevelWindow game = GameWindow() with { IsMinimised = true, Client = default, Bounds = new(-32000, -32000, -31840, -31972) };

        Assert.Equal(GrabRefusals.Minimised, Judge([small, game]).Refusal);
    }

    [Fact]
    public void Judge_keeps_the_known_window_until_it_closes()
    {
        TopLevelWindow known = Window(2, Game, new(600, 0, 700, 50));
        TopLevelWindow[] both = [GameWindow(), known];

        Assert.Equal(2, WindowJudge.Judge(new DesktopView(both, [Monitor]), Game, 2).Window);
        Assert.Equal(1, WindowJudge.Judge(new DesktopView([GameWindow()], [Monitor]), Game, 2).Window);
    }

    [Fact]
    public void Judge_drops_a_handle_reused_by_another_process() =>
        Assert.Equal(
            1,
            WindowJudge.Judge(new DesktopView([GameWindow(), Window(2, Other, new(600, 0, 700, 50))], [Monitor]), Game, 2).Window
        );

    private static WindowVerdict Judge(TopLevelWindow[] windows, params DesktopRectangle[] monitors) =>
        WindowJudge.Judge(new DesktopView(windows, monitors.Length == 0 ? [Monitor] : monitors), Game, 0);

    private static TopLevelWindow GameWindow() => Window(1, Game, Client);

    private static TopLevelWindow Window(long handle, int process, DesktopRectangle area) =>
        new(
            handle,
            process,
            IsApplication: true,
            IsMinimised: false,
            ShowsNothing: false,
            area,
            area,
            RestoredArea: area.IsEmpty ? 120_000 : area.Area
        );
}
