using Harvester.Geometry.Work;

namespace Harvester.Geometry.Tests.Work;

public sealed class WorkRunTests
{
    private readonly List<string> _done = [];
    private bool _isTickOver;

    [Fact]
    public void Nothing_is_done_before_the_first_tick()
    {
        using var run = new WorkRun(Outer());

        Assert.Empty(_done);
    }

    [Fact]
    public void Work_begun_by_a_step_is_done_before_the_next_step()
    {
        using var run = new WorkRun(Outer());

        Assert.True(run.Advance());
        Assert.Equal(["outer 1", "inner 1"], _done);
        Assert.False(run.Advance());
        Assert.Equal(["outer 1", "inner 1", "inner 2", "inner ended", "outer 2", "outer ended"], _done);
        Assert.False(run.Advance());
    }

    [Theory]
    [InlineData(false, 1)]
    [InlineData(true, 3)]
    public void Pause_ends_a_tick_only_if_its_time_is_over(bool isTickOver, int ticks)
    {
        _isTickOver = isTickOver;
        using var run = new WorkRun(Enumerable.Repeat(WorkStep.Pause, 2), () => _isTickOver);

        Assert.Equal(ticks, 1 + Enumerable.Range(0, 10).TakeWhile(_ => run.Advance()).Count());
    }

    [Fact]
    public void Step_without_a_phase_is_in_that_of_its_work()
    {
        _isTickOver = true;
        using var run = new WorkRun(Phases(), () => _isTickOver);
        var phases = new List<int?>();
        while (run.Advance())
        {
            phases.Add(run.Phase);
        }

        Assert.Equal([null, 1, 1, 2, 1, 3], phases);

        static IEnumerable<WorkStep> Phases()
        {
            yield return WorkStep.Tick;
            yield return WorkStep.Do(First(), 1);
            yield return WorkStep.TickIn(3);
        }

        static IEnumerable<WorkStep> First()
        {
            yield return WorkStep.Tick;
            yield return WorkStep.Do([WorkStep.Pause]);
            yield return WorkStep.Do([WorkStep.Tick], 2);
            yield return WorkStep.Pause;
        }
    }

    [Fact]
    public void Disposing_ends_the_innermost_work_first()
    {
        var run = new WorkRun(Outer());
        run.Advance();
        run.Dispose();
        run.Dispose();

        Assert.Equal(["outer 1", "inner 1", "inner ended", "outer ended"], _done);
        Assert.False(run.Advance());
    }

    [Fact]
    public void Disposing_before_the_first_tick_does_nothing()
    {
        var run = new WorkRun(Outer());
        run.Dispose();

        Assert.False(run.Advance());
        Assert.Empty(_done);
    }

    [Fact]
    public void Exception_ends_all_works_and_is_thrown()
    {
        using var run = new WorkRun(Around(Failing()));

        Assert.Equal("fails", Assert.Throws<InvalidOperationException>(() => run.Advance()).Message);
        Assert.Equal(["around ended"], _done);
        Assert.False(run.Advance());

        static IEnumerable<WorkStep> Failing()
        {
            yield return WorkStep.Pause;
            throw new InvalidOperationException("fails");
        }
    }

    [Fact]
    public void All_works_end_even_if_ending_one_fails()
    {
        var run = new WorkRun(Around(EndingFails()));
        run.Advance();

        Assert.Throws<InvalidOperationException>(run.Dispose);
        Assert.Equal(["around ended"], _done);

        static IEnumerable<WorkStep> EndingFails()
        {
            try
            {
                yield return WorkStep.Tick;
            }
            finally
            {
                Fail();
            }
        }

        static void Fail() => throw new InvalidOperationException("fails");
    }

    [Fact]
    public void Work_that_needs_a_tick_cannot_be_done_at_once()
    {
        WorkRun.Complete([WorkStep.Pause]);

        Assert.Throws<InvalidOperationException>(() => WorkRun.Complete(Outer()));
        Assert.Equal(["outer 1", "inner 1", "inner ended", "outer ended"], _done);
    }

    [Fact]
    public void Steps_allocate_nothing()
    {
        using var run = new WorkRun(Steps());
        run.Advance();
        long before = GC.GetAllocatedBytesForCurrentThread();
        run.Advance();

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        static IEnumerable<WorkStep> Steps()
        {
            yield return WorkStep.Tick;
            for (int step = 0; step < 1000; step++)
            {
                yield return WorkStep.Pause;
            }

            yield return WorkStep.Tick;
        }
    }

    private IEnumerable<WorkStep> Outer()
    {
        try
        {
            _done.Add("outer 1");
            yield return WorkStep.Do(Inner());
            _done.Add("outer 2");
        }
        finally
        {
            _done.Add("outer ended");
        }
    }

    private IEnumerable<WorkStep> Inner()
    {
        try
        {
            _done.Add("inner 1");
            yield return WorkStep.Tick;
            _done.Add("inner 2");
        }
        finally
        {
            _done.Add("inner ended");
        }
    }

    private IEnumerable<WorkStep> Around(IEnumerable<WorkStep> work)
    {
        try
        {
            yield return WorkStep.Do(work);
        }
        finally
        {
            _done.Add("around ended");
        }
    }
}
