using Harvester.Datasets.Validation;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>The one problem that damage must give.</summary>
internal static class ProblemAssertions
{
    public static void AssertProblem(this TestSession session, int line, string message) =>
        SessionValidator.Validate(session.Open()).AssertProblem(line, message);

    public static void AssertProblem(this SessionValidation validation, int line, string message)
    {
        // A line that cannot be read also makes the count of session.json wrong; that is a problem of another file.
        SessionProblem problem = Assert.Single(validation.Problems, problem => problem.Line is not null);
        Assert.Equal(line, problem.Line);
        Assert.Contains(message, problem.Message, StringComparison.Ordinal);
    }
}
