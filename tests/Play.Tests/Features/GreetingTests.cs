using Harvester.Play.Features;
using Harvester.Play.Screen;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Features;

public sealed class GreetingTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("greeting").FullName;
    private readonly List<string> _told = [];
    private readonly PlayerMessages _messages;
    private readonly FeatureSet _features;

    public GreetingTests()
    {
        var clock = new TestClock();
        _messages = new PlayerMessages(_folder, _told.Add, clock);
        _features = new FeatureSet(_messages, new TestCalls(), clock);
    }

    public void Dispose()
    {
        _messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(_folder, recursive: true);
    }

    [Theory]
    [InlineData("800 x 600, windowed, 96 dpi, HDR is on", 1)]
    [InlineData("800 x 600, windowed, 96 dpi", 0)]
    public void Hdr_is_warned_of_once(string window, int warnings)
    {
        Greeting greeting = Greeting(new DescribedWindow(() => window));

        greeting.Tick(_features);
        greeting.Tick(_features);

        Assert.Equal(warnings, _told.Count(message => message.Contains("HDR is on in Windows", StringComparison.Ordinal)));
    }

    [Fact]
    public void Window_that_cannot_be_described_is_logged_as_unknown()
    {
        Greeting(new DescribedWindow(() => throw new EntryPointNotFoundException("GetDpiForWindow"))).Tick(_features);

        _messages.Wait(Timeout.InfiniteTimeSpan);
        string log = File.ReadAllText(Path.Combine(_folder, "GtaDataHarvester.log"));
        Assert.Contains("Window: unknown (GetDpiForWindow).", log, StringComparison.Ordinal);
    }

    private Greeting Greeting(IGameWindow window) => new("GtaDataHarvester 0.1.0", new ModFolder(_folder), window, tape: null, _messages);

    private sealed class DescribedWindow(Func<string> describe) : IGameWindow
    {
        public string Describe() => describe();
    }
}
