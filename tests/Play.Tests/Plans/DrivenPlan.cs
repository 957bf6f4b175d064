using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.TestSupport;

namespace Harvester.Play.Tests.Plans;

/// <summary>A test of plans that are run in a <see cref="TrialWorld"/>.</summary>
public abstract class DrivenPlan : IDisposable
{
    private static readonly TimeSpan HangingAfter = TimeSpan.FromMinutes(1);

    protected DrivenPlan() => Messages = new PlayerMessages(Root, Told.Add, new TestClock());

    /// <summary>The folder of the test.</summary>
    protected string Root { get; } = Directory.CreateTempSubdirectory("plan-driving").FullName;

    /// <summary>The messages to the player.</summary>
    protected List<string> Told { get; } = [];

    protected PlayerMessages Messages { get; }

    internal TrialWorld World { get; } = new();

    /// <summary>The output of the plan named two.</summary>
    protected string Output => Path.Combine(Root, "plans", "two");

    public void Dispose()
    {
        Messages.Wait(Timeout.InfiniteTimeSpan);
        Directory.Delete(Root, recursive: true);
        GC.SuppressFinalize(this);
    }

    protected PlanFeature Driving(string text)
    {
        string file = Path.Combine(Root, "plan.json");
        File.WriteAllText(file, text);
        return new PlanFeature(file, Path.Combine(Root, "plans"), World.Surroundings, Messages);
    }

    protected string[] StatusLines()
    {
        string path = Path.Combine(Output, "plan-status.jsonl");
        return File.Exists(path) ? File.ReadAllText(path).Split('\n', StringSplitOptions.RemoveEmptyEntries) : [];
    }

    protected string Heartbeat()
    {
        string path = Path.Combine(Output, "heartbeat.json");
        string text = "";
        SpinWait.SpinUntil(
            () => File.Exists(path) && (text = File.ReadAllText(path)).Contains("\"trial\":null", StringComparison.Ordinal),
            HangingAfter
        );
        return text;
    }

    protected void UntilOff(PlanFeature plan) => Until(plan, () => !plan.IsOn && !plan.IsBusy);

    protected void Until(PlanFeature plan, Func<bool> isSo)
    {
        var hanging = System.Diagnostics.Stopwatch.StartNew();
        do
        {
            Assert.True(hanging.Elapsed < HangingAfter, string.Join('\n', Told));
            if (plan.IsBusy)
            {
                Thread.Sleep(1);
            }

            World.Pass();
            plan.Tick();
        } while (!isSo());
    }
}
